#include "simspark/Patience.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <functional>
#include <thread>

namespace plumbline::simspark {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// A process that does what it is given, without end.
class Endless {
public:
  explicit Endless(void (*work)()) : pid(fork()) {
    if (pid == 0)
      for (;;) work();
  }
  ~Endless() {
    kill(pid, SIGKILL);
    waitpid(pid, nullptr, 0);
  }
  Endless(const Endless&) = delete;
  Endless& operator=(const Endless&) = delete;
  const pid_t pid;
};

/// What the process has computed [s].
double computed(pid_t process) {
  clockid_t clock;
  timespec time{};
  EXPECT_EQ(clock_getcpuclockid(process, &clock), 0);
  EXPECT_EQ(clock_gettime(clock, &time), 0);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

constexpr double pauseOfLooks = 0.002;  // [s]

/// How long it took until it was over, at most so long [s]; after each look at which it was not, `then` is
/// called.
double lasts(
    pid_t process, double seconds, double atMost, const std::function<void()>& then = [] {}) {
  const auto begin = Clock::now();
  for (Patience patience(process, seconds); !patience.isOver() && since(begin) < atMost;) {
    then();
    usleep(static_cast<useconds_t>(1e6 * pauseOfLooks));
  }
  return since(begin);
}

/// That the time of the clock counts. A look takes its pause and more, so that a busy machine needs fewer.
void expectTheClock(pid_t process) {
  constexpr double patience = 0.1;  // [s]
  int looks = 0;
  EXPECT_GE(lasts(process, patience, 60, [&] { ++looks; }), patience);
  EXPECT_LE(looks, patience / pauseOfLooks + 1);
}

void computes() {
  static volatile unsigned counter = 0;
  counter = counter + 1;
}
void sleeps() { pause(); }

TEST(Patience, ofAProcessThatHangsIsThatOfTheClock) {
  const Endless child(sleeps);
  expectTheClock(child.pid);
}

TEST(Patience, ofAStoppedProcessIsThatOfTheClock) {
  const Endless child(computes);
  kill(child.pid, SIGSTOP);
  int status = 0;
  ASSERT_EQ(waitpid(child.pid, &status, WUNTRACED), child.pid);
  expectTheClock(child.pid);
}

TEST(Patience, ofAProcessThatComputesIsWhatItRuns) {
  const Endless child(computes);
  const double before = computed(child.pid);
  double ran = 0;
  EXPECT_GE(lasts(child.pid, 0.1, 60, [&] { ran = computed(child.pid) - before; }), 0.1);
  // Linux counts in ticks what another process runs, and a look may miss some.
  EXPECT_LT(ran, 1) << "at the last look that it passed";
}

TEST(Patience, ofAProcessThatDoesNotGetTheProcessorGoesOn) {
  cpu_set_t allowed, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof allowed, &allowed), 0);
  CPU_ZERO(&one);
  for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++cpu)
    if (CPU_ISSET(cpu, &allowed)) CPU_SET(cpu, &one);
  const Endless child(computes);
  const sched_param none{};
  ASSERT_EQ(sched_setscheduler(child.pid, SCHED_IDLE, &none), 0);
  ASSERT_EQ(sched_setaffinity(child.pid, sizeof one, &one), 0);
  std::atomic<bool> end = false;
  std::thread other([&] {
    sched_setaffinity(0, sizeof one, &one);
    while (!end) computes();
  });
  usleep(50000);
  EXPECT_GE(lasts(child.pid, 0.1, 1), 1);
  end = true;
  other.join();
}

TEST(Patience, ofAProcessThatIsNoMoreIsThatOfTheClock) { EXPECT_GE(lasts(1 << 29, 0.05, 60), 0.05); }

}  // namespace
}  // namespace plumbline::simspark
