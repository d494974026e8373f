#include "field/FieldFile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace plumbline {
namespace {

class FieldFile : public testing::Test {
protected:
  std::string file(const std::string& text) {
    std::ofstream(path) << text;
    return path;
  }
  std::string errorOf(const std::string& text) {
    try {
      readFieldFile(file(text));
    } catch (const std::exception& error) {
      std::string what = error.what();
      if (what.starts_with(path)) what.erase(0, path.size());
      return what;
    }
    return "none";
  }
  const std::string path = testing::TempDir() + "field-of-a-test.yaml";
  void TearDown() override { std::filesystem::remove(path); }
};

TEST_F(FieldFile, theProjectsOneIsTheLeagues) { EXPECT_EQ(readFieldFile("config/field.yaml"), FieldSize()); }

TEST_F(FieldFile, namesWhatDiffers) {
  FieldSize expected;
  expected.length = 9;
  expected.width = 6;
  expected.centreCircleRadius = 0.75;
  EXPECT_EQ(readFieldFile(file("length: 9\nwidth: 6\ncentreCircleRadius: 0.75\n")), expected);
}

TEST_F(FieldFile, anUnknownKeyIsAnErrorWithTheNearest) {
  EXPECT_EQ(errorOf("length: 9\ngoalwidth: 2\n"),
            ":2: unknown key \"goalwidth\"; did you mean \"goalWidth\"?");
}

TEST_F(FieldFile, everySizeHasItsRange) {
  EXPECT_EQ(errorOf("length: 0.5\n"), ":1: length must be within [1, 1000], not 0.5");
  EXPECT_EQ(errorOf("width: wide\n"), ":1: width must be a number, not \"wide\"");
  EXPECT_EQ(errorOf("ballRadius: -1\n"), ":1: ballRadius must be within [0.001, 1], not -1");
}

/// Of two sizes the one that the file sets is named, the small one if it sets both.
TEST_F(FieldFile, sizesMustGoTogether) {
  EXPECT_EQ(errorOf("goalWidth: 7\n"), ":1: goalWidth must be at most penaltyWidth, 6, not 7");
  EXPECT_EQ(errorOf("penaltyWidth: 1.5\n"), ":1: penaltyWidth must be at least goalWidth, 2.1, not 1.5");
  EXPECT_EQ(errorOf("length: 3\n"), ":1: length must be at least twice penaltyDepth, 3.6, not 3");
  EXPECT_EQ(errorOf("length: 4\nwidth: 9\npenaltyDepth: 3\n"),
            ":3: penaltyDepth must be at most half of length, 2, not 3");
  EXPECT_EQ(errorOf("goalHeight: 0.3\nballRadius: 0.2\n"),
            ":2: ballRadius must be at most half of goalHeight, 0.15, not 0.2");
}

TEST_F(FieldFile, thatIsNotThereIsAnError) {
  EXPECT_THROW(readFieldFile("config/no-field.yaml"), std::exception);
}

}  // namespace
}  // namespace plumbline
