#include "simulation/replay/StartState.h"

#include <gtest/gtest.h>

#include "math/Angle.h"
#include "simspark/LeagueRobots.h"
#include "simulation/replay/TraceReplay.h"

namespace plumbline::simulation {
namespace {

using simspark::LeagueTrace;
using simspark::TraceRow;

LeagueTrace read(const std::string& name) {
  return simspark::readLeagueTrace("tests/data/traces/" + name + ".csv.gz");
}

std::vector<TraceRow> play(const LeagueTrace& trace) {
  return replayTrace(trace, simsparkRobot(trace.robotType.value_or(0)));
}

class Start : public testing::TestWithParam<const char*> {};

/// Load tears gaps into the hinges; the feet stand 0.1 mm from where the joints alone put them.
TEST_P(Start, HasTheGapsOfTheRecording) {
  const LeagueTrace trace = read(GetParam());
  const auto ours = play(trace);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(ours[i].leftFoot.translation().z(), trace.rows[i].leftFoot.translation().z(), 4e-6) << i;
    EXPECT_NEAR(ours[i].rightFoot.translation().z(), trace.rows[i].rightFoot.translation().z(), 4e-6) << i;
  }
}

/// What is off at the start turns the whole way.
TEST_P(Start, HasTheHeadingOfTheRecording) {
  const LeagueTrace trace = read(GetParam());
  const auto ours = play(trace);
  double mean = 0;
  for (std::size_t i = 0; i < 100; ++i) {
    const Mat3 off = ours[i].torso.linear() * trace.rows[i].torso.linear().transpose();
    mean += std::atan2(off(1, 0), off(0, 0)) / 100;
  }
  EXPECT_LT(std::abs(toDegrees(mean)), 2e-4);
}

INSTANTIATE_TEST_SUITE_P(Traces, Start,
                         testing::Values("crouch_t0", "crouch_t1", "swing_t0", "ut_walk_t0", "ut_walk_t1",
                                         "ut_walk_t2", "ut_walk_replay_t0", "ut_turn_t1"));

/// The engine turns by less than speed times step; a head that turns at 1.5 rad/s was a cycle off by 0.00014
/// degrees, for ever.
TEST(StartState, JointsTurnAsTheEngineTurnsThem) {
  const LeagueTrace trace = read("ut_walk_t0");
  const auto ours = play(trace);
  const double turn = trace.rows[1].axisAngle[headYaw] - trace.rows[0].axisAngle[headYaw];
  const StartState start = startState(trace, simsparkRobot(0));
  EXPECT_NEAR(2 * std::atan(0.01 * start.rate[headYaw]), turn, 1e-15);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(toDegrees(ours[i].axisAngle[headYaw]), toDegrees(trace.rows[i].axisAngle[headYaw]), 1.2e-4)
        << i;
}

TEST(StartState, KnowsWhoSleeps) {
  EXPECT_TRUE(startState(read("ut_walk_replay_t0"), simsparkRobot(0)).asleep);
  const StartState falling = startState(read("stand_t0"), simsparkRobot(0));
  EXPECT_FALSE(falling.asleep);
  EXPECT_NEAR(falling.torso.pose.translation().z(), 0.4, 1e-5) << "where a beam puts it";
  EXPECT_NEAR(falling.torso.linearVelocity.norm(), 0, 1e-3) << "at rest";
}

}  // namespace
}  // namespace plumbline::simulation
