#include "framework/StopSignal.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "framework/Parallel.h"
#include "support/FarOff.h"

namespace plumbline {
namespace {

bool readable(int descriptor) {
  pollfd entry{descriptor, POLLIN, 0};
  return poll(&entry, 1, 0) == 1;
}

TEST(StopSignalTest, theFirstRequestCounts) {
  StopSignal stop;
  EXPECT_FALSE(stop.requested());
  EXPECT_FALSE(readable(stop.fileDescriptor()));
  stop.request(3, "first");
  stop.request(4, "second");
  EXPECT_TRUE(stop.requested());
  EXPECT_TRUE(readable(stop.fileDescriptor()));
  EXPECT_EQ(stop.exitCode(), 3);
  EXPECT_EQ(stop.reason(), "first");
}

TEST(StopSignalTest, wakesWhoPolls) {
  StopSignal stop;
  std::thread other([&] { stop.request(1, "other"); });
  pollfd entry{stop.fileDescriptor(), POLLIN, 0};
  EXPECT_EQ(poll(&entry, 1, static_cast<int>(1000 * farOff)), 1);
  EXPECT_TRUE(stop.requested());
  other.join();
}

TEST(StopSignalTest, signalsAreRequests) {
  for (const auto& [signal, reason] :
       {std::pair(SIGINT, "interrupted (SIGINT)"), std::pair(SIGTERM, "terminated (SIGTERM)"),
        std::pair(SIGHUP, "terminal closed (SIGHUP)")}) {
    StopSignal stop;
    stop.catchSignals();
    raise(signal);
    EXPECT_TRUE(stop.requested());
    EXPECT_TRUE(readable(stop.fileDescriptor()));
    stop.request(3, "later");
    EXPECT_EQ(stop.exitCode(), 0);
    EXPECT_EQ(stop.reason(), reason);
  }
}

TEST(StopSignalTest, longWorkIsStoppedFromWithin) {
  StopSignal::throwIfCaught();
  {
    StopSignal stop;
    stop.catchSignals();
    StopSignal::throwIfCaught();
    raise(SIGTERM);
    EXPECT_THROW(StopSignal::throwIfCaught(), Stopped);
    EXPECT_THROW(parallel(100, 3, [](std::size_t) { FAIL() << "no work is begun"; }), Stopped);
  }
  StopSignal::throwIfCaught();
}

TEST(StopSignalTest, aSecondSignalEndsTheProcess) {
  EXPECT_EXIT(
      {
        StopSignal stop;
        stop.catchSignals();
        raise(SIGINT);
        // Longer than two signals are one wish; a busy machine only adds to it.
        std::this_thread::sleep_for(std::chrono::milliseconds(400));
        raise(SIGINT);
      },
      testing::KilledBySignal(SIGINT), "");
}

// Such as `timeout` sends: to the child and to its group.
TEST(StopSignalTest, aSignalThatComesTwiceAtOnceIsOneRequest) {
  // A busy machine may put so long a time between them that they are two: a child is ended by them then.
  int status = -1;
  for (int tries = 0; tries < 20 && status != 0; ++tries) {
    const pid_t child = fork();
    if (child == 0) {
      StopSignal stop;
      stop.catchSignals();
      raise(SIGINT);
      raise(SIGINT);
      raise(SIGTERM);
      _exit(stop.requested() && stop.reason() == "interrupted (SIGINT)" ? 0 : 1);
    }
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_FALSE(WIFEXITED(status) && WEXITSTATUS(status) != 0) << "another request";
  }
  EXPECT_EQ(status, 0);
}

TEST(StopSignalTest, goesOnAfterTheTerminalClosedIfStartedByNohup) {
  EXPECT_EXIT(
      {
        std::signal(SIGHUP, SIG_IGN);
        {
          StopSignal stop;
          stop.catchSignals();
          raise(SIGHUP);
          if (stop.requested()) std::exit(1);
          raise(SIGTERM);
          if (!stop.requested()) std::exit(2);
        }
        raise(SIGHUP);
        std::exit(0);
      },
      testing::ExitedWithCode(0), "");
}

TEST(StopSignalTest, afterItsEndSignalsDoWhatTheyDid) {
  EXPECT_EXIT(
      {
        { StopSignal().catchSignals(); }
        raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
}  // namespace plumbline
