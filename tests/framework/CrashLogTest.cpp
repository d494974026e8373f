#include "framework/CrashLog.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

#include "framework/LogBuffer.h"
#include "framework/TestModules.h"
#include "support/FarOff.h"

namespace plumbline {

int endlessRecursion(int depth) {
  volatile char frame[4096];
  frame[0] = static_cast<char>(depth);
  return depth < 0 ? 0 : endlessRecursion(depth + 1) + frame[0];
}

/// Dies in its 600th cycle, in a way the test chooses.
std::string& wayToDie() {
  static std::string way;
  return way;
}

MODULE(Crasher)
END_MODULE
class Crasher : public CrasherBase {
public:
  void execute() override {
    log << "cycle " << ++cycle_;
    if (cycle_ != 600) return;
    if (wayToDie() == "fault") {
      volatile std::uintptr_t nowhere = 64;
      *reinterpret_cast<volatile int*>(nowhere) = 1;
    }
    if (wayToDie() == "abort") std::abort();
    if (wayToDie() == "recursion") log << endlessRecursion(0);
    if (wayToDie() == "kill") kill(getpid(), SIGKILL);
    if (wayToDie() == "pipe") raise(SIGPIPE);
    if (wayToDie() == "hang-up") raise(SIGHUP);
    if (wayToDie() == "ctrl-c") raise(SIGINT);
    if (wayToDie() == "terminate") raise(SIGTERM);
    if (wayToDie() == "ctrl-c twice") {
      raise(SIGINT);
      usleep(400000);  // longer than two signals are one wish; a busy machine only adds to it
      raise(SIGINT);
    }
    if (wayToDie() == "with its starter") {
      kill(getppid(), SIGKILL);
      for (;;) pause();
    }
    if (wayToDie() == "exit") std::exit(7);
    if (wayToDie() == "stop") requestStop(5, "enough");
  }

private:
  int cycle_ = 0;
};
MAKE_MODULE(Crasher)

namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif
#if defined(__SANITIZE_THREAD__)
constexpr bool faultIsTheSanitizers = true;  // it ends in the sanitizer's own exit code
#else
constexpr bool faultIsTheSanitizers = sanitized;
#endif

/// The second processes of agents that have died become this process's children.
class OrphansCome {
public:
  OrphansCome() { prctl(PR_SET_CHILD_SUBREAPER, 1); }
  ~OrphansCome() { prctl(PR_SET_CHILD_SUBREAPER, 0); }
  OrphansCome(const OrphansCome&) = delete;
  OrphansCome& operator=(const OrphansCome&) = delete;
  static void waitForAll() {
    while (wait(nullptr) > 0 || errno == EINTR) {
    }
  }
};

/// The agent runs in a child process, as it is to die.
class CrashLogTest : public testing::Test {
protected:
  CrashLogTest() { std::filesystem::create_directories(folder); }
  ~CrashLogTest() override { std::filesystem::remove_all(folder); }

  /// The agent's wait status.
  int run(const std::string& way, const std::string& modulesConfig) {
    wayToDie() = way;
    const pid_t child = fork();
    if (child == 0) {
      if (stderrOfChild >= 0)
        dup2(stderrOfChild, STDERR_FILENO);
      else if (!std::freopen((folder + "/stderr").c_str(), "w", stderr))
        _exit(99);
      std::signal(SIGPIPE, SIG_DFL);  // whoever runs the tests may ignore it
      int status = 98;
      {
        if (beforeTheLog) beforeTheLog();
        const unsigned secondsToDie = stderrOfChild >= 0 ? 3 : 30;
        CrashLog crashLog(folder + "/crash.log", secondsToDie);
        Controller controller = makeController(modulesConfig);
        controller.stop().catchSignals();
        status = controller.run();
      }
      // All children of an agent that ends in order are gone.
      if (waitpid(-1, nullptr, WNOHANG) != -1 || errno != ECHILD) status = 97;
      _exit(status);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
  }
  std::string contents(const std::string& name) const {
    std::stringstream text;
    text << std::ifstream(folder + "/" + name).rdbuf();
    return text.str();
  }
  /// The second process may still be writing when the agent is gone.
  void waitForLog() const {
    EXPECT_TRUE(comesTrue([this] { return hasLog(); }));
  }
  bool hasLog() const { return std::filesystem::exists(folder + "/crash.log"); }

  int stderrOfChild = -1;  ///< -1: a file
  void (*beforeTheLog)() = nullptr;
  const std::string folder = testing::TempDir() + "crash" + std::to_string(getpid());
};

TEST_F(CrashLogTest, tellsSignalStepAndLastMessages) {
  const int status = run("fault", "[main 3]\nAlphaSource Alpha\nCrasher\n");
  EXPECT_TRUE(faultIsTheSanitizers || (WIFSIGNALED(status) && WTERMSIG(status) == SIGSEGV)) << status;
  ASSERT_TRUE(hasLog());
  const std::string text = contents("crash.log");
  EXPECT_NE(text.find(" died by SIGSEGV (Segmentation fault), "), std::string::npos) << text;
  EXPECT_NE(text.find("\nThreads:\n[main] Crasher:execute <- the signal struck here\n"), std::string::npos);
  EXPECT_NE(text.find("\nCalls, innermost first"), std::string::npos);
  EXPECT_NE(text.find("\nLast messages, oldest first:\n[Crasher] cycle 89\n"), std::string::npos);
  EXPECT_EQ(text.substr(text.size() - 21), "\n[Crasher] cycle 600\n");
  EXPECT_EQ(contents("stderr").substr(0, contents("stderr").find('\n')),
            "died by SIGSEGV in Crasher:execute; see " + folder + "/crash.log");
}

TEST_F(CrashLogTest, tellsWhichThreadDied) {
  // On a busy machine the crash may come before the other thread has begun, which then has nothing to tell.
  for (int i = 0; i < 10 && contents("crash.log").find("[quiet] ") == std::string::npos; ++i)
    run("fault", "[quiet 3]\nAlphaSource Alpha\n[loud 2]\nCrasher\n");
  EXPECT_NE(contents("crash.log").find("[loud] Crasher:execute <- the signal struck here\n"),
            std::string::npos);
  EXPECT_NE(contents("crash.log").find("[quiet] "), std::string::npos);
}

TEST_F(CrashLogTest, tellsAnAbort) {
  const int status = run("abort", "Crasher\n");
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT);
  EXPECT_NE(contents("crash.log").find("died by SIGABRT (Aborted)"), std::string::npos);
}

TEST_F(CrashLogTest, tellsABrokenPipe) {
  const int status = run("pipe", "Crasher\n");
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGPIPE);
  EXPECT_NE(contents("crash.log").find("died by SIGPIPE (Broken pipe)"), std::string::npos);
}

TEST_F(CrashLogTest, tellsAStackOverflowInEveryThread) {
  if (sanitized) GTEST_SKIP() << "the sanitizer keeps signal stacks of its own";
  run("recursion", "Crasher\n");
  EXPECT_NE(contents("crash.log").find("died by SIGSEGV"), std::string::npos);
  std::filesystem::remove(folder + "/crash.log");
  run("recursion", "[a 1]\nAlphaSource\n[b 1]\nCrasher\n");
  EXPECT_NE(contents("crash.log").find("[b] Crasher:execute <- the signal struck here"), std::string::npos);
}

TEST_F(CrashLogTest, theAgentIsGoneThoughNobodyReadsItsLastWords) {
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_NONBLOCK), 0);
  const std::string full(4096, 'x');
  while (write(ends[1], full.data(), full.size()) > 0) {
  }
  ASSERT_EQ(fcntl(ends[1], F_SETFL, 0), 0);  // from now on, who writes waits for ever
  for (const auto& [way, signal] : {std::pair("abort", SIGABRT), std::pair("pipe", SIGPIPE)}) {
    std::filesystem::remove(folder + "/crash.log");
    stderrOfChild = ends[1];
    const int status = run(way, "Crasher\n");
    EXPECT_TRUE(WIFSIGNALED(status)) << way;
    EXPECT_EQ(WTERMSIG(status), signal) << way;
    waitForLog();
    EXPECT_NE(contents("crash.log").find(" died by "), std::string::npos)
        << "written before the words are said";
  }
  close(ends[0]);
  close(ends[1]);
}

TEST_F(CrashLogTest, tellsThatTheAgentWasKilled) {
  run("kill", "Crasher\n");
  // Nobody waits for the second process then.
  waitForLog();
  EXPECT_NE(contents("crash.log").find(" was killed by a signal that it cannot catch (SIGKILL), "),
            std::string::npos);
  EXPECT_NE(contents("crash.log")
                .find(":\nby hand, by the program that started it, or by Linux because "
                      "memory was short.\n\nThreads:\n"),
            std::string::npos);
  EXPECT_NE(contents("crash.log").find("[default] Crasher:execute\n"), std::string::npos);
}

TEST_F(CrashLogTest, theEndOfWhoStartedItAndTakesItAlongLeavesNothing) {
  const OrphansCome orphans;
  const pid_t starter = fork();
  if (starter == 0) {
    // What ChildProcess asks for, in the agent.
    beforeTheLog = [] { prctl(PR_SET_PDEATHSIG, SIGKILL); };
    run("with its starter", "Crasher\n");
    _exit(0);
  }
  int status = 0;
  waitpid(starter, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << status;
  OrphansCome::waitForAll();
  EXPECT_FALSE(hasLog());
}

TEST_F(CrashLogTest, whoIsTakenAlongButDiesAloneLeavesALog) {
  const OrphansCome orphans;
  beforeTheLog = [] { prctl(PR_SET_PDEATHSIG, SIGKILL); };
  run("kill", "Crasher\n");
  OrphansCome::waitForAll();
  EXPECT_TRUE(hasLog());
}

TEST_F(CrashLogTest, aSecondCtrlCLeavesNothing) {
  const OrphansCome orphans;
  const int status = run("ctrl-c twice", "Crasher\n");
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;
  OrphansCome::waitForAll();
  EXPECT_FALSE(hasLog()) << contents("crash.log");
}

TEST_F(CrashLogTest, anEndInOrderLeavesNothing) {
  for (const auto& [way, code] : {std::pair("stop", 5), std::pair("ctrl-c", 0), std::pair("hang-up", 0),
                                  std::pair("terminate", 0), std::pair("exit", 7)}) {
    const int status = run(way, "Crasher\n");
    EXPECT_TRUE(WIFEXITED(status)) << way;
    EXPECT_EQ(WEXITSTATUS(status), code) << way;
    EXPECT_FALSE(hasLog()) << way;
    EXPECT_EQ(contents("stderr"), "") << way;
  }
}

}  // namespace
}  // namespace plumbline
