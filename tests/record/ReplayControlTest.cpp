#include "record/ReplayControl.h"

#include <gtest/gtest.h>

namespace plumbline::record {
namespace {

using Turn = ReplayControl::Turn;

/// Plays until it rests; returns how many cycles there were.
std::size_t play(ReplayControl& control, std::size_t player, std::size_t& played) {
  std::size_t cycles = 0;
  for (;;) {
    switch (control.next(player, played)) {
      case Turn::wait:
        return cycles;
      case Turn::restart:
        played = 0;
        continue;
      default:
        control.played(player, ++played);
        cycles++;
    }
  }
}

TEST(ReplayControlTest, playsAllAndSaysWhenAllHave) {
  ReplayControl control("log", {});
  control.addPlayer({10, 20});
  control.addPlayer({15});
  EXPECT_EQ(control.next(0, 0), Turn::cycle);
  EXPECT_FALSE(control.played(0, 1));
  EXPECT_FALSE(control.played(0, 2));
  EXPECT_TRUE(control.played(1, 1));
}

TEST(ReplayControlTest, stepsGoOnAndBackwardsEverythingIsPlayedAgain) {
  ReplayControl control("log", {.paused = true});
  control.addPlayer({1'000'000'000, 1'020'000'000, 1'040'000'000, 1'060'000'000});
  std::size_t played = 0;
  EXPECT_EQ(play(control, 0, played), 0u);
  control.step(1);
  EXPECT_EQ(play(control, 0, played), 1u);
  control.step(2);
  EXPECT_EQ(play(control, 0, played), 2u);
  EXPECT_EQ(played, 3u);
  EXPECT_EQ(control.time(), 1.04);
  control.step(-1);
  EXPECT_EQ(control.next(0, played), Turn::restart);
  played = 0;
  EXPECT_EQ(control.next(0, played), Turn::unseen);
  EXPECT_EQ(play(control, 0, played), 2u);
  EXPECT_EQ(control.position(), 2u);
  control.goToTime(1.05);
  EXPECT_EQ(play(control, 0, played), 1u);
  EXPECT_EQ(control.position(), 3u);
  control.goTo(1000);
  EXPECT_EQ(play(control, 0, played), 1u);
  control.goToTime(0);
  play(control, 0, played);
  EXPECT_EQ(control.position(), 0u);
}

TEST(ReplayControlTest, otherThreadsFollowToTheLeadersTime) {
  ReplayControl control("log", {.paused = true});
  control.addPlayer({10, 20, 30});
  control.addPlayer({5, 12, 14, 25, 40});
  std::size_t leader = 0, follower = 0;
  control.goTo(2);
  EXPECT_EQ(play(control, 0, leader), 2u);
  EXPECT_EQ(play(control, 1, follower), 3u);
  control.goTo(3);
  EXPECT_EQ(play(control, 0, leader), 1u);
  EXPECT_EQ(play(control, 1, follower), 2u);
  control.goTo(1);
  play(control, 0, leader);
  play(control, 1, follower);
  EXPECT_EQ(leader, 1u);
  EXPECT_EQ(follower, 1u);
}

TEST(ReplayControlTest, keepsThePaceOfTheRecording) {
  ReplayControl control("log", {.speed = 2});
  control.addPlayer({0, 100'000'000, 200'000'000});
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t played = 0; played < 3;) {
    if (control.next(0, played) == Turn::wait) continue;
    control.played(0, ++played);
  }
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(99));
}

}  // namespace
}  // namespace plumbline::record
