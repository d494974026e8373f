#include "gap/inference/Visible.h"

#include <gtest/gtest.h>

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

TEST(Visible, whatIsTooSmallIsNotProposed) {
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings({}));
  const Replayer replayer(arm, groups, 1);
  const Shares shares = sharesOf(groups, replayer.residuals({}));
  for (const Proposal& proposal : CandidateScreening(replayer, shares).propose(replayer, {}, shares, 24))
    EXPECT_TRUE(isVisible(replayer, {proposal.cause}, 0)) << describe(proposal.cause);
}

}  // namespace plumbline::gap
