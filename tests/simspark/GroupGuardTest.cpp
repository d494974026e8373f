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

TEST(GroupGuard, killsTheGroupWhenItsParentIsKilledWithAllOfItsOwnGroup) {
  const pid_t group = groupOfOne();
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t parent = fork();
  if (parent == 0) {
    setpgid(0, 0);
    const GroupGuard guard(group);
    [[maybe_unused]] const auto told = write(ends[1], "x", 1);
    for (;;) pause();
  }
  char told = 0;
  ASSERT_EQ(read(ends[0], &told, 1), 1);
  kill(-parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  int status = 0;
  EXPECT_EQ(waitpid(group, &status, 0), group);
  EXPECT_EQ(WTERMSIG(status), SIGKILL);
  close(ends[0]);
  close(ends[1]);
}

}  // namespace
}  // namespace plumbline::simspark
