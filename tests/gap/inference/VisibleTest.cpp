#include "gap/inference/Visible.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../ThreeRecordings.h"
#include "gap/inference/CandidateScreening.h"
#include "gap/inference/Density.h"

namespace plumbline::gap {

TEST(Visible, aCauseIsThatMovesAChannelByMoreThanEnginesDiffer) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}));
  const Replayer replayer(arm, groups, 1);
  const Explanation causes{causeOfArm("coulomb_friction", "elbow", 0.1),
                           causeOfArm("coulomb_friction", "shoulder", 1e-5)};
  EXPECT_TRUE(isVisible(replayer, causes, 0));
  EXPECT_FALSE(isVisible(replayer, causes, 1));
}

TEST(Visible, theLineIsAtHalfTheNoise) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}));
  const Replayer replayer(arm, groups, 1);
  // How far a friction moves its channels at the most, in units of their noise.
  const auto moved = [&](double value) {
    const Explanation causes{causeOfArm("viscous_friction", "elbow", value)};
    const Residuals with = replayer.residuals(causes), rest = replayer.residuals({});
    double most = 0;
    for (const Cell& cell : groups.cells()) {
      const std::vector<double> a = residualsOf(cell, with), b = residualsOf(cell, rest);
      double squares = 0;
      for (std::size_t k = 0; k < a.size(); ++k) squares += (a[k] - b[k]) * (a[k] - b[k]);
      most = std::max(most, std::sqrt(squares / static_cast<double>(a.size())) / cell.noise);
    }
    return most;
  };
  double low = 0, high = 0.1;  // of a friction that moves them by half the noise
  for (int i = 0; i < 20; ++i) (moved((low + high) / 2) < 0.5 ? low : high) = (low + high) / 2;
  ASSERT_GT(low, 1e-5);
  EXPECT_FALSE(isVisible(replayer, {causeOfArm("viscous_friction", "elbow", 0.9 * low)}, 0));
  EXPECT_TRUE(isVisible(replayer, {causeOfArm("viscous_friction", "elbow", 1.1 * low)}, 0));
}

TEST(Visible, whatIsTooSmallIsNotProposed) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}));
  const Replayer replayer(arm, groups, 1);
  const Shares shares = sharesOf(groups, replayer.residuals({}));
  for (const Proposal& proposal : CandidateScreening(replayer, shares).propose(replayer, {}, shares, 24))
    EXPECT_TRUE(isVisible(replayer, {proposal.cause}, 0)) << describe(proposal.cause);
}

}  // namespace plumbline::gap
