#include "gap/inference/Density.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../DutyTrial.h"

namespace plumbline::gap {

TEST(Density, anEffortHasNoMoreIndependentSamplesThanItsJointsPosition) {
  // Another mass leaves slow residuals of the position, and of the duty the noise alone.
  const Mechanism pendulum = findMechanism("xl330_pendulum");
  std::vector<Trial> trials;
  for (const double size : {0.5, 0.3})
    trials.push_back(dutyTrial({causeOf(pendulum, "link_mass", "arm", 0.1)}, 6, 5e-4, 3, size));
  const Groups groups(trials);
  const Replayer replayer(pendulum, groups, 1);
  const Residuals residuals = replayer.residuals({});
  const Shares shares = sharesOf(groups, residuals);
  for (std::size_t c = 0; c < groups.cells().size(); ++c) {
    const Cell& cell = groups.cells()[c];
    if (groups.trials()[cell.trial].signals[cell.signal].kind != SignalKind::duty) continue;
    EXPECT_GT(1 / residuals[cell.trial][cell.signal]->correlationOf(cell.from, cell.to), 0.2);
    EXPECT_LT(shares[c], 0.2);
    for (std::size_t other = 0; other < groups.cells().size(); ++other) {
      const Cell& of = groups.cells()[other];
      if (of.trial == cell.trial && of.from == cell.from && of.signal == 0) {
        EXPECT_EQ(shares[c], shares[other]);
      }
    }
  }
}

}  // namespace plumbline::gap
