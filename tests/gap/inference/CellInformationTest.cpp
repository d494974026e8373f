#include "gap/inference/CellInformation.h"

#include <gtest/gtest.h>

#include "../ThreeRecordings.h"
#include "gap/inference/Fit.h"

namespace plumbline::gap {

TEST(CellInformation, isWhatAFitHasPerGroup) {
  const Explanation causes{causeOfArm("viscous_friction", "shoulder", 0.15),
                           causeOfArm("bias_force", "elbow", 0.2)};
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings(causes));
  const Replayer replayer(arm, groups, 1);
  const Residuals left = replayer.residuals(causes);
  const Shares shares = sharesOf(groups, left);
  const Fitted fitted = fit(replayer, shares, causes, 0);
  std::vector<Eigen::MatrixXd> sums(groups.count(), Eigen::MatrixXd::Zero(2, 2));
  for (const CellInformation& of : informationOf(replayer, shares, causes, left))
    sums[groups.cells()[of.cell].group] += of.about + of.mean;
  for (std::size_t g = 0; g < groups.count(); ++g) {
    EXPECT_TRUE(sums[g].isApprox(fitted.information[g], 1e-9)) << sums[g];
    EXPECT_GT(sums[g](0, 0), 0);
    EXPECT_GT(sums[g](1, 1), 0);
  }
}

TEST(CellInformation, theOtherGroupsAreNotLookedAt) {
  const Explanation causes{causeOfArm("viscous_friction", "shoulder", 0.15)};
  const Mechanism arm = twoJointArm();
  const Groups groups(recordings(causes));
  const Replayer replayer(arm, groups, 1);
  const Residuals left = replayer.residuals(causes);
  const std::vector<CellInformation> some =
      informationOf(replayer, sharesOf(groups, left), causes, left, {0, 1, 0});
  ASSERT_FALSE(some.empty());
  for (const CellInformation& of : some) EXPECT_EQ(groups.cells()[of.cell].group, 1);
}

}  // namespace plumbline::gap
