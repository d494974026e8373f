#include "framework/RunDot.h"

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "framework/StopSignal.h"
#include "support/OtherDot.h"
#include "support/Processes.h"

namespace plumbline {
namespace {

struct RunDotTest : testing::Test {
  const std::string folder = testing::TempDir() + "/dot" + std::to_string(getpid());
  std::string run(double seconds = 60) const { return runDot("svg", "in.dot", folder + "/out", seconds); }
};

TEST_F(RunDotTest, passesOnWhatShallBeDrawn) {
  const test::OtherDot dot(folder, "echo \"$@\" > '" + folder + "/out'");
  EXPECT_EQ(run(), "");
  std::string line;
  std::getline(std::ifstream(folder + "/out") >> std::ws, line);
  EXPECT_EQ(line, "-Tsvg in.dot -o " + folder + "/out");
}

TEST_F(RunDotTest, saysThatItFailed) {
  const test::OtherDot dot(folder, "exit 3");
  EXPECT_EQ(run(), "dot failed");
}

TEST_F(RunDotTest, whatHangsHasALimitAndEndsWithWhatItStarted) {
  const test::OtherDot dot(folder, "sleep 1000 &\necho $! > '" + folder + "/child'\nwait");
  EXPECT_EQ(run(1),
            "dot has not drawn it within 1 s; write a .dot file and see what `dot -Tsvg FILE.dot` does");
  pid_t child = 0;
  if (std::ifstream(folder + "/child") >> child) {
    EXPECT_TRUE(processEnds(child));
  }
}

TEST_F(RunDotTest, aSignalEndsIt) {
  const test::OtherDot dot(folder, "trap '' INT TERM\nsleep 1000");
  StopSignal stop;
  stop.catchSignals();
  pid_t pid = 0;
  std::thread person([&] {
    pid = dot.waitUntilItRuns();
    kill(getpid(), SIGINT);
  });
  EXPECT_THROW(run(), Stopped);
  person.join();
  EXPECT_TRUE(processEnds(pid));
}

TEST_F(RunDotTest, ofAnAgentThatWasStoppedBeforeItIsWaitedFor) {
  StopSignal stop;
  stop.catchSignals();
  raise(SIGINT);
  {
    const test::OtherDot dot(folder, "exit 0");
    EXPECT_EQ(run(), "");
  }
  const test::OtherDot dot(folder, "sleep 1000");
  EXPECT_EQ(run(0.1),
            "dot has not drawn it within 0.1 s; write a .dot file and see what `dot -Tsvg FILE.dot` does");
}

}  // namespace
}  // namespace plumbline
