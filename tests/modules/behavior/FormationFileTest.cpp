#include "modules/behavior/formation/FormationFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "support/Thrown.h"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

constexpr const char* small = R"(# whose places
ballX: [-10, 10]
ballY: [0, 8]
places:
  - name: cover  # in the middle
    x:
      - [-12, -4.0]
      - [-12, -4]
    y:
      - [0, 0]  # a row of its own
      - [6, 6]
)";

class FormationFileTest : public testing::Test {
protected:
  FormationFileTest()
      : folder(fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name()),
        path(folder / "formation.yaml") {
    fs::remove_all(folder);
    fs::create_directories(folder);
    put(small);
  }
  ~FormationFileTest() override { fs::remove_all(folder); }
  void put(const std::string& text) const { std::ofstream(path) << text; }
  std::string text() const {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::string problemOf(const FormationDraft& draft) const {
    return thrownBy([&] { file().write(draft); });
  }
  FormationFile file() const { return FormationFile(path); }

  fs::path folder, path;
};

TEST_F(FormationFileTest, whatIsMovedIsWrittenAndTheRestStays) {
  FormationDraft draft = file().read();
  ASSERT_EQ(draft.comment, "");
  EXPECT_EQ(draft.ballX, (std::vector<double>{-10, 10}));
  ASSERT_EQ(draft.places.size(), 1u);
  draft.places[0].x[0][1] = -3.25;
  draft.places[0].y[1][0] = 7;
  EXPECT_TRUE(file().write(draft));
  std::string wanted = small;
  wanted.replace(wanted.find("-4.0]"), 4, "-3.25");
  wanted.replace(wanted.find("[6, 6]"), 6, "[7.0, 6]");
  EXPECT_EQ(text(), wanted);
  const FormationDraft after = file().read();
  EXPECT_EQ(after.places[0].x[0][1], -3.25);
  EXPECT_NE(after.revision, draft.revision);
  EXPECT_FALSE(file().write(after));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1)
      << "nothing beside it";
}

TEST_F(FormationFileTest, whatIsNoFormationIsRefusedAndTheFileStays) {
  const FormationDraft good = file().read();
  FormationDraft draft = good;
  draft.places[0].x[0][0] = 101;
  EXPECT_EQ(problemOf(draft), path.string() + ": cover: 101 is no number from -100 to 100");
  draft.places[0].x[0][0] = std::nan("");
  EXPECT_EQ(problemOf(draft), path.string() + ": cover: nan is no number from -100 to 100");
  const std::string others = path.string() + ": the draft has other places or balls than the file";
  draft = good;
  draft.places[0].y.pop_back();
  EXPECT_EQ(problemOf(draft), others);
  draft = good;
  draft.ballY[1] = 9;
  EXPECT_EQ(problemOf(draft), others);
  draft = good;
  draft.places.clear();
  EXPECT_EQ(problemOf(draft), others);
  EXPECT_EQ(text(), small);
}

TEST_F(FormationFileTest, whatSomebodyElseWroteMeanwhileIsNotOverwritten) {
  FormationDraft draft = file().read();
  draft.places[0].x[0][0] = 1;
  const std::string theirs = std::string(small) + "# theirs\n";
  put(theirs);
  EXPECT_EQ(problemOf(draft), path.string() + " was changed by somebody else; nothing is written");
  EXPECT_EQ(text(), theirs);
}

TEST_F(FormationFileTest, aFileThatIsNoFormationSaysWhy) {
  put("ballX: [1, 2]\n");
  EXPECT_EQ(file().read().comment, path.string() + ":1: missing key \"ballY\"");
  fs::remove(path);
  EXPECT_NE(file().read().comment, "");
}

TEST_F(FormationFileTest, theProjectsOwnCanBeEdited) {
  fs::copy_file("config/formation.yaml", path, fs::copy_options::overwrite_existing);
  FormationDraft draft = file().read();
  ASSERT_EQ(draft.comment, "");
  for (FormationDraftPlace& place : draft.places)
    for (auto* table : {&place.x, &place.y})
      for (std::vector<double>& row : *table)
        for (double& value : row) value += 0.5;
  EXPECT_TRUE(file().write(draft));
  EXPECT_EQ(file().read().places.back().x, draft.places.back().x);
}

}  // namespace
}  // namespace plumbline
