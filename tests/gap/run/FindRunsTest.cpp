#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "gap/run/RunFile.h"
#include "support/ScratchFolder.h"

namespace plumbline::gap {
namespace {

namespace fs = std::filesystem;

void makeRun(const fs::path& folder) {
  fs::create_directories(folder);
  std::ofstream(folder / "run.json") << "{}";
}

TEST(FindRuns, runsSevenFoldersBelowAreFoundAndDeeperOnesAreNot) {
  const test::ScratchFolder scratch;
  const fs::path root = scratch.path();
  makeRun(root / "1/2/3/4/5/6/7");
  makeRun(root / "a/2/3/4/5/6/7/8");
  EXPECT_EQ(findRuns(root.string()), std::vector<std::string>{(root / "1/2/3/4/5/6/7").string()});
}

TEST(FindRuns, runsNextToAFolderThatIsTooDeepAreFound) {
  const test::ScratchFolder scratch;
  const fs::path root = scratch.path();
  std::vector<std::string> expected;
  for (const char* branch : {"a", "b", "c", "d", "e", "f"}) {
    fs::create_directories(root / branch / "2/3/4/5/6/7/8/9");
    makeRun(root / branch / "run");
    expected.push_back((root / branch / "run").string());
  }
  EXPECT_EQ(findRuns(root.string()), expected);
}

}  // namespace
}  // namespace plumbline::gap
