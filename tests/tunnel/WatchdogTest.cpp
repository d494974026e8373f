#include "tunnel/Watchdog.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>

#include "support/FarOff.h"

namespace plumbline::tunnel {
namespace {

struct Ended {
  int status;
  double seconds;
};

/// What becomes of a process that does this with a watchdog; 77 if it comes to its end.
Ended processWith(
    double silence, const std::function<void(Watchdog&, StopSignal&)>& body,
    const std::function<void(pid_t)>& meanwhile = [](pid_t) {}) {
  const auto begin = std::chrono::steady_clock::now();
  const pid_t pid = fork();
  if (pid == 0) {
    StopSignal stop;
    {
      Watchdog watchdog(stop, silence);
      body(watchdog, stop);
    }
    _exit(77);
  }
  meanwhile(pid);
  int status = 0;
  waitpid(pid, &status, 0);
  return {WEXITSTATUS(status),
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()};
}

void beatFor(Watchdog& watchdog, int milliseconds) {
  for (int i = 0; i < milliseconds; i += 5) {
    watchdog.beat();
    usleep(5000);
  }
}

TEST(Watchdog, leavesALoopAloneThatGoesOn) {
  const Ended end = processWith(1, [](Watchdog& watchdog, StopSignal&) { beatFor(watchdog, 1500); });
  EXPECT_EQ(end.status, 77);
}

TEST(Watchdog, endsALoopThatStandsForTooLong) {
  const Ended end = processWith(0.3, [](Watchdog&, StopSignal&) { sleep(3600); });
  EXPECT_EQ(end.status, 2);
  EXPECT_LT(end.seconds, farOff);
}

TEST(Watchdog, endsALoopThatDoesNotEndOnASignal) {
  const Ended end = processWith(3600, [](Watchdog& watchdog, StopSignal& stop) {
    stop.request(0, "stop");
    beatFor(watchdog, 3600000);
  });
  EXPECT_EQ(end.status, 130);
  EXPECT_GT(end.seconds, 0.5);
  EXPECT_LT(end.seconds, farOff);
}

TEST(Watchdog, endsWithTheStatusThatIsGiven) {
  const Ended end = processWith(3600, [](Watchdog& watchdog, StopSignal&) {
    watchdog.ending(5);
    sleep(3600);
  });
  EXPECT_EQ(end.status, 5);
}

TEST(Watchdog, endsALoopThatStandsWhenMpirunBeginsToEndIt) {
  const Ended end = processWith(3600, [](Watchdog&, StopSignal&) {
    raise(SIGCONT);
    for (;;) sleep(60);
  });
  EXPECT_EQ(end.status, 130);
  EXPECT_LT(end.seconds, farOff);
}

TEST(Watchdog, doesNotCountTheTimeInWhichTheProcessIsStopped) {
  const Ended end = processWith(
      1, [](Watchdog& watchdog, StopSignal&) { beatFor(watchdog, 400); },
      [](pid_t pid) {
        usleep(100000);
        kill(pid, SIGSTOP);
        usleep(1500000);
        kill(pid, SIGCONT);
      });
  EXPECT_EQ(end.status, 77);
}

}  // namespace
}  // namespace plumbline::tunnel
