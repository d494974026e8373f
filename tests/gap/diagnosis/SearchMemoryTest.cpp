#include "gap/diagnosis/SearchMemory.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

class SearchMemoryTest : public ::testing::Test {
protected:
  SearchMemoryTest() { std::filesystem::remove(path); }
  ~SearchMemoryTest() override { std::filesystem::remove(path); }

  const Mechanism arm = twoJointArm();
  const std::string path = ::testing::TempDir() + "plumbline-search-memory";
};

TEST_F(SearchMemoryTest, aFileOfAnotherMarkOrADamagedOneIsNotTaken) {
  SearchMemory memory(path, "mark", arm);
  memory.keep({}, {});
  EXPECT_EQ(SearchMemory(path, "mark", arm).size(), 1u);
  EXPECT_EQ(SearchMemory(path, "other", arm).size(), 0u);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 3);
  EXPECT_EQ(SearchMemory(path, "mark", arm).size(), 0u);
}

TEST_F(SearchMemoryTest, ASearchIsFoundByAllItStartedFrom) {
  SearchMemory memory(path, "mark", arm);
  const SearchStart start{{causeOfArm("viscous_friction", "elbow", 0.1)}, 3, {{0, 1}}};
  memory.keep(start, {{}, {{1, 0}}});
  const SearchMemory again(path, "mark", arm);
  ASSERT_TRUE(again.find(start));
  EXPECT_EQ(again.find(start)->lostCycles, (std::vector<std::vector<std::uint8_t>>{{1, 0}}));
  SearchStart other = start;
  other.leastGain = 4;
  EXPECT_FALSE(again.find(other));
  other = start;
  other.lostCycles[0][0] = 1;
  EXPECT_FALSE(again.find(other));
  other = start;
  other.base[0].value = 0.2;
  EXPECT_FALSE(again.find(other));
}

TEST_F(SearchMemoryTest, aFileThatCannotBeWrittenIsReportedOnceAndStopsNothing) {
  std::vector<std::string> problems;
  SearchMemory memory("/proc/none/searches", "mark", arm,
                      [&](const std::string& problem) { problems.push_back(problem); });
  memory.keep({}, {});
  memory.keep({}, {});
  EXPECT_EQ(problems, std::vector<std::string>{
                          "cannot write /proc/none/searches: No such file or directory; a diagnosis "
                          "that is stopped from now on repeats what follows"});
  EXPECT_EQ(memory.size(), 0u);
}

}  // namespace
}  // namespace plumbline::gap
