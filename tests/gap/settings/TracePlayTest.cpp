#include "gap/settings/TracePlay.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/Thrown.h"

namespace plumbline::gap {
namespace {

TEST(TracePlay, RepeatsTheServerWithinATenthOfAMillimetre) {
  const auto trace = simspark::readLeagueTrace("tests/data/traces/ut_walk_t0.csv.gz");
  const auto rows = play(trace, 100, 5, {});
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_LT((rows[4].torso.translation() - trace.rows[105].torso.translation()).norm(), 3e-4);
  EXPECT_NEAR(rows[4].angle[lKneePitch], trace.rows[105].angle[lKneePitch], 2e-3);
  // Played a cycle too early, the knee is elsewhere.
  SimulatorSetup early;
  early.delay = 0;
  EXPECT_GT(std::abs(play(trace, 100, 5, early)[2].angle[lKneePitch] - trace.rows[103].angle[lKneePitch]),
            0.01);
}

TEST(TracePlay, SaysWhereItCannotBegin) {
  const auto trace = simspark::readLeagueTrace("tests/data/traces/crouch_t0.csv.gz");
  EXPECT_EQ(thrownBy([&] { play(trace, 2, 5, {}); }), "crouch_t0: no replay from row 2");
}

}  // namespace
}  // namespace plumbline::gap
