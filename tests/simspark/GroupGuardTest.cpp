#include "simspark/GroupGuard.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <memory>

#include "support/Processes.h"

namespace plumbline::simspark {
namespace {

/// A process that is a group of its own and waits for ever.
pid_t groupOfOne() {
  const pid_t pid = fork();
  if (pid == 0) {
    setpgid(0, 0);
    for (;;) pause();
  }
  setpgid(pid, pid);
  return pid;
}

TEST(GroupGuard, thatIsNotNeededAnyLongerLeavesTheGroupAlone) {
  const pid_t group = groupOfOne();
  auto guard = std::make_unique<GroupGuard>(group);
  const pid_t pid = guard->pid();
  guard.reset();
  EXPECT_TRUE(processEnded(pid));
  usleep(50000);
  EXPECT_FALSE(processEnded(group));
  kill(group, SIGKILL);
  waitpid(group, nullptr, 0);
}

TEST(GroupGuard, thatWasKilledDoesNoHarmToItsParent) {
  const pid_t parent = fork();
  if (parent == 0) {
    {
      const GroupGuard guard(getpid());
      kill(guard.pid(), SIGKILL);
      while (!processEnded(guard.pid())) usleep(1000);
    }
    _exit(77);
  }
  int status = 0;
  waitpid(parent, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 77);
}

/// Whether a group ends that a process guards which is killed with its own group at once.
bool endsWithItsParent() {
  const pid_t group = groupOfOne();
  int ends[2];
  if (pipe(ends) != 0) return false;
  const pid_t parent = fork();
  if (parent == 0) {
    setpgid(0, 0);
    const GroupGuard guard(group);
    [[maybe_unused]] const auto written = write(ends[1], "x", 1);
    for (;;) pause();
  }
  char byte = 0;
  if (read(ends[0], &byte, 1) != 1) return false;
  kill(-parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  const bool ended = processEnds(group);
  if (!ended) kill(group, SIGKILL);
  waitpid(group, nullptr, 0);
  close(ends[0]);
  close(ends[1]);
  return ended;
}

TEST(GroupGuard, killsTheGroupWhenItsParentIsKilledWithAllOfItsOwnGroup) {
  // Often: a guard that is still on its way out of its parent's group would go with it.
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(endsWithItsParent()) << i;
}

}  // namespace
}  // namespace plumbline::simspark
