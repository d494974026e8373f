#include "simspark/ChildProcess.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

using plumbline::simspark::ChildProcess;

namespace {

void waitForEnd(ChildProcess& child) {
  for (int i = 0; i < 1000 && child.running(); ++i) usleep(5000);
}

TEST(ChildProcess, reportsTheExitStatusAndWritesItsOutputToTheFile) {
  const std::string file = testing::TempDir() + "child_process_output.txt";
  std::filesystem::remove(file);
  ChildProcess child({"/bin/sh", "-c", "echo out; echo err >&2; exit 7"}, file);
  waitForEnd(child);
  ASSERT_TRUE(child.exitStatus().has_value());
  EXPECT_EQ(*child.exitStatus(), 7);
  std::stringstream content;
  content << std::ifstream(file).rdbuf();
  EXPECT_EQ(content.str(), "out\nerr\n");
}

TEST(ChildProcess, aProgramThatIsNotThereIsAnError) {
  try {
    ChildProcess child({"/no/such/program"});
    FAIL() << "started";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "cannot start /no/such/program: No such file or directory");
  }
}

TEST(ChildProcess, stopEndsItAndTellsTheSignal) {
  ChildProcess child({"/bin/sleep", "100"});
  EXPECT_TRUE(child.running());
  child.stop();
  EXPECT_EQ(*child.exitStatus(), 128 + SIGTERM);
}

TEST(ChildProcess, stopKillsWhatDoesNotListen) {
  ChildProcess child({"/bin/sh", "-c", "trap '' TERM; while :; do sleep 0.01; done"});
  usleep(100000);  // until the trap is set
  child.stop(0.2);
  EXPECT_EQ(*child.exitStatus(), 128 + SIGKILL);
}

TEST(ChildProcess, countsTheProcessorTimeOfTheChild) {
  ChildProcess child({"/bin/sh", "-c", "i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done"});
  waitForEnd(child);
  EXPECT_EQ(*child.exitStatus(), 0);
  EXPECT_GT(child.usage().cpuSeconds, 0.005);
  EXPECT_GT(child.usage().maxResidentMegabytes, 0.3);
}

}  // namespace
