#include "simspark/ChildProcess.h"

#include <gtest/gtest.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <list>
#include <sstream>

#include "support/FarOff.h"
#include "support/Processes.h"
#include "support/Thrown.h"

using plumbline::comesTrue;
using plumbline::processEnds;
using plumbline::simspark::ChildProcess;
using plumbline::simspark::ChildSettings;

namespace {

std::string contentOf(const std::string& file) {
  std::stringstream content;
  content << std::ifstream(file).rdbuf();
  return content.str();
}

/// A file of this test's own, which is not there yet.
std::string freshFile(const std::string& name) {
  const std::string file = testing::TempDir() + name;
  std::filesystem::remove(file);
  return file;
}

/// The number that a child writes into a file.
pid_t numberIn(const std::string& file) {
  comesTrue([&] { return contentOf(file).find('\n') != std::string::npos; });
  return static_cast<pid_t>(std::stoi(contentOf(file)));
}

void waitForEnd(ChildProcess& child) {
  comesTrue([&] { return !child.running(); });
}

TEST(ChildProcess, reportsTheExitStatusAndWritesItsOutputToTheFile) {
  const std::string file = freshFile("child_process_output.txt");
  ChildProcess child({"/bin/sh", "-c", "echo out; echo err >&2; exit 7"}, file);
  waitForEnd(child);
  ASSERT_TRUE(child.exitStatus().has_value());
  EXPECT_EQ(*child.exitStatus(), 7);
  EXPECT_FALSE(child.running()) << "however often it is asked";
  EXPECT_EQ(contentOf(file), "out\nerr\n");
}

TEST(ChildProcess, aProgramThatIsNotThereIsAnError) {
  try {
    ChildProcess child({"/no/such/program"});
    FAIL() << "started";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "cannot start /no/such/program: No such file or directory");
  }
}

TEST(ChildProcess, aProgramThatIsNotThereIsAnErrorAlsoWhereSignalsInterruptTheStart) {
  struct sigaction ignore {};
  ignore.sa_handler = [](int) {};  // without SA_RESTART: what waits is woken
  struct sigaction before {};
  sigaction(SIGALRM, &ignore, &before);
  int missed = 0;
  for (int i = 0; i < 300; ++i) {
    const itimerval once{{}, {0, 100 + 5 * i}};  // at another place of the start each time
    setitimer(ITIMER_REAL, &once, nullptr);
    missed += plumbline::thrownBy([] { ChildProcess child({"/no/such/program"}); }) != "nothing thrown";
  }
  const itimerval never{};
  setitimer(ITIMER_REAL, &never, nullptr);
  sigaction(SIGALRM, &before, nullptr);
  EXPECT_EQ(missed, 300);
}

TEST(ChildProcess, stopEndsItAndTellsTheSignal) {
  ChildProcess child({"/bin/sleep", "100"});
  EXPECT_TRUE(child.running());
  child.stop();
  EXPECT_EQ(*child.exitStatus(), 128 + SIGTERM);
}

// Its number may be another process's by then.
TEST(ChildProcess, whatHasEndedIsNeitherWaitedForNorSignalled) {
  ChildProcess child({"/bin/sh", "-c", "exit 3"});
  waitForEnd(child);
  const auto begin = std::chrono::steady_clock::now();
  child.stop(60);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 30);
  EXPECT_EQ(*child.exitStatus(), 3);
}

TEST(ChildProcess, stopKillsWhatDoesNotListen) {
  ChildProcess child({"/bin/sh", "-c", "trap '' TERM; while :; do sleep 0.01; done"});
  usleep(100000);  // until the trap is set
  child.stop(0.2);
  EXPECT_EQ(*child.exitStatus(), 128 + SIGKILL);
}

TEST(ChildProcess, whatIsAskedTogetherHasItsTimeTogether) {
  std::list<ChildProcess> children;
  for (int i = 0; i < 30; ++i) {
    children.emplace_back(std::vector<std::string>{"/bin/sleep", "100"});
    kill(children.back().pid(), SIGSTOP);
    int status = 0;
    ASSERT_EQ(waitpid(children.back().pid(), &status, WUNTRACED), children.back().pid());
  }
  const auto begin = std::chrono::steady_clock::now();
  for (ChildProcess& child : children) child.askToStop(1);
  for (ChildProcess& child : children) child.stop(1);
  const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_GE(took, 1);
  EXPECT_LT(took, 20) << "one after another they take thirty seconds";
  for (ChildProcess& child : children) EXPECT_EQ(*child.exitStatus(), 128 + SIGKILL);
}

TEST(ChildProcess, countsTheProcessorTimeOfTheChild) {
  ChildProcess child({"/bin/sh", "-c", "i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done"});
  waitForEnd(child);
  EXPECT_EQ(*child.exitStatus(), 0);
  EXPECT_GT(child.usage().cpuSeconds, 0.005);
  EXPECT_GT(child.usage().maxResidentMegabytes, 0.3);
}

TEST(ChildProcess, itsEnvironmentIsWhatIsInheritedButForWhatIsSetAndDropped) {
  const std::string file = freshFile("child_process_environment.txt");
  setenv("CHILD_TEST_KEPT", "kept", 1);
  setenv("CHILD_TEST_SET", "old", 1);
  setenv("OTHER_TEST_DROPPED", "dropped", 1);
  const std::string print = "echo $CHILD_TEST_KEPT,$CHILD_TEST_SET,$CHILD_TEST_NEW,$OTHER_TEST_DROPPED";
  ChildProcess child({"/bin/sh", "-c", print},
                     ChildSettings{.outputFile = file,
                                   .environment = {"CHILD_TEST_SET=new", "CHILD_TEST_NEW=a=b"},
                                   .dropped = {"OTHER_TEST_"}});
  waitForEnd(child);
  for (const char* name : {"CHILD_TEST_KEPT", "CHILD_TEST_SET", "OTHER_TEST_DROPPED"}) unsetenv(name);
  EXPECT_EQ(contentOf(file), "kept,new,a=b,\n");
}

TEST(ChildProcess, aNameIsLookedForOnPathOnlyWhereThatIsWanted) {
  ChildProcess child({"true"}, ChildSettings{.onPath = true});
  waitForEnd(child);
  EXPECT_EQ(*child.exitStatus(), 0);
  EXPECT_EQ(plumbline::thrownBy([] { ChildProcess missing({"true"}, ChildSettings{.onPath = false}); }),
            "cannot start true: No such file or directory");
  EXPECT_EQ(
      plumbline::thrownBy([] { ChildProcess missing({"no-such-program"}, ChildSettings{.onPath = true}); }),
      "cannot start no-such-program: No such file or directory");
}

TEST(ChildProcess, hasNothingOpenButTheThreeStandardFiles) {
  const std::string file = freshFile("child_process_descriptors.txt");
  const int open = dup(STDIN_FILENO);  // inherited, were it not for what is tested
  ASSERT_GT(open, STDERR_FILENO);
  ChildProcess child({"/bin/ls", "/proc/self/fd"}, file);  // 3: the folder itself
  waitForEnd(child);
  close(open);
  EXPECT_EQ(contentOf(file), "0\n1\n2\n3\n");
}

TEST(ChildProcess, isTheLeaderOfAGroupThatCanBeSignalled) {
  ChildProcess child({"/bin/sh", "-c", "sleep 3600 & wait"});
  EXPECT_EQ(getpgid(child.pid()), child.pid());
  child.signalGroup(SIGTERM);
  waitForEnd(child);
  EXPECT_EQ(*child.exitStatus(), 128 + SIGTERM);
}

TEST(ChildProcess, aWholeGroupEndsWithItsLeader) {
  const std::string file = freshFile("child_process_group.txt");
  ChildProcess child({"/bin/sh", "-c", "sleep 3600 & echo $!; exit 3"},
                     ChildSettings{.outputFile = file, .wholeGroup = true});
  const pid_t grandchild = numberIn(file);
  waitForEnd(child);
  EXPECT_EQ(*child.exitStatus(), 3);
  EXPECT_TRUE(processEnds(grandchild));
}

TEST(ChildProcess, stopEndsTheWholeGroup) {
  const std::string file = freshFile("child_process_stopped_group.txt");
  ChildProcess child({"/bin/sh", "-c", "trap '' TERM; (trap '' TERM; sleep 3600) & echo $!; wait"},
                     ChildSettings{.outputFile = file, .wholeGroup = true});
  const pid_t grandchild = numberIn(file);
  child.stop(0.2);
  EXPECT_EQ(*child.exitStatus(), 128 + SIGKILL);
  EXPECT_TRUE(processEnds(grandchild));
}

TEST(ChildProcess, aWholeGroupEndsWithAParentThatIsKilled) {
  const std::string file = freshFile("child_process_orphans.txt");
  const pid_t parent = fork();
  if (parent == 0) {
    setpgid(0, 0);
    const ChildProcess child({"/bin/sh", "-c", "sleep 3600 & echo $!; wait"},
                             ChildSettings{.outputFile = file, .wholeGroup = true});
    for (;;) pause();
  }
  const pid_t grandchild = numberIn(file);
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  EXPECT_TRUE(processEnds(grandchild));
}

TEST(ChildProcess, aWholeGroupEndsWithAParentThatIsKilledWhileItStartsIt) {
  // The child kills its parent as soon as it has a child of its own.
  for (int i = 0; i < 10; ++i) {
    const std::string file = freshFile("child_process_early_orphans.txt");
    const pid_t parent = fork();
    if (parent == 0) {
      setpgid(0, 0);
      const ChildProcess child({"/bin/sh", "-c", "sleep 3600 & echo $!; kill -KILL $PPID; wait"},
                               ChildSettings{.outputFile = file, .wholeGroup = true});
      for (;;) pause();
    }
    const pid_t grandchild = numberIn(file);
    waitpid(parent, nullptr, 0);
    ASSERT_TRUE(processEnds(grandchild)) << "try " << i;
  }
}

}  // namespace
