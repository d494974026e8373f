#include "modules/infrastructure/CognitionConfigLoader.h"

#include <gtest/gtest.h>

#include <memory>

#include "support/ModuleHarness.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

class CognitionConfigLoaderTest : public testing::Test {
protected:
  CognitionConfigLoaderTest() { folder.write("field.yaml", "length: 14\nwidth: 9\n"); }
  const FieldDimensions& field() {
    harness.cycle();
    return harness.output<FieldDimensions>();
  }
  test::ScratchFolder folder;
  test::ModuleHarness<CognitionConfigLoader> harness{{folder.path()}};
};

TEST_F(CognitionConfigLoaderTest, readsTheFieldOfTheConfiguration) {
  EXPECT_EQ(field().length, 14);
  EXPECT_EQ(field().width, 9);
  EXPECT_EQ(field().goalWidth, 2.1) << "the default";
  EXPECT_EQ(field().opponentGoal(), Vec2(7, 0));
}

TEST_F(CognitionConfigLoaderTest, theCommandLinesFileComesBeforeIt) {
  folder.write("small.yaml", "length: 6\n");
  harness.objects().set(std::make_shared<FieldChoice>(FieldChoice{folder / "small.yaml"}));
  EXPECT_EQ(field().length, 6);
}

TEST_F(CognitionConfigLoaderTest, anEmptyChoiceIsNone) {
  harness.objects().set(std::make_shared<FieldChoice>());
  EXPECT_EQ(field().length, 14);
}

TEST_F(CognitionConfigLoaderTest, aFieldThatCannotBeIsAnErrorAtTheStart) {
  folder.write("field.yaml", "length: 0\n");
  EXPECT_EQ(thrownBy([&] { harness.module(); }),
            folder / "field.yaml" + ":1: length must be within [1, 1000], not 0");
  test::ModuleHarness<CognitionConfigLoader> other({"config"});
  other.objects().set(std::make_shared<FieldChoice>(FieldChoice{folder / "gone.yaml"}));
  EXPECT_NE(thrownBy([&] { other.module(); }).find("gone.yaml"), std::string::npos);
}

}  // namespace
}  // namespace plumbline
