#include "gap/inference/MostToGain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../LegOnItsFoot.h"
#include "../ThreeRecordings.h"

namespace plumbline::gap {

namespace {

std::vector<char> trialsWorthLooking(const std::vector<Trial>& trials, const Mechanism& robot,
                                     const Cause& cause) {
  const Groups groups(trials);
  const Replayer replayer(robot, groups, 1);
  return MostToGain(replayer, sharesOf(groups, replayer.residuals({})), 100).trialsFor(cause);
}

MostOfCell mostOf(const std::vector<double>& left) { return {split(left), fitStretch(split(left), 1.2), 1}; }

}  // namespace

TEST(MostToGain, nothingWhereNothingIsLeft) {
  const Cause cause = causeOfArm("coulomb_friction", "elbow", 0.1);
  EXPECT_EQ(trialsWorthLooking(recordings({}), twoJointArm(), cause), std::vector<char>(3, 0));
}

TEST(MostToGain, aMomentFarBeyondTheNoise) {
  // A fifth of a second, forty times the noise: for a scale with heavy tails a few outliers.
  std::vector<Trial> trials = recordings({});
  for (std::size_t k = 200; k < 220; ++k) trials[1].signals[1].values[k] += 0.02;
  const Cause cause = causeOfArm("thermal_derating", "elbow", 0.02);
  EXPECT_EQ(trialsWorthLooking(trials, twoJointArm(), cause), std::vector<char>(3, 1));
}

TEST(MostOfCell, ofWhatIsAtTheNoiseAFewValuesFarBeyondCanBeGained) {
  Random random(5);
  std::vector<double> left;
  for (int k = 0; k < 300; ++k) left.push_back(random.gaussian());
  const MostOfCell noise = mostOf(left);
  EXPECT_TRUE(noise.isAtNoise);
  EXPECT_LT(noise.gain, 2);
  for (std::size_t k = 100; k < 108; ++k) left[k] += 20;
  const MostOfCell few = mostOf(left);
  EXPECT_TRUE(few.isAtNoise);
  EXPECT_GT(few.gain, 50);
  for (double& value : left) value *= 3;
  EXPECT_FALSE(mostOf(left).isAtNoise);
}

TEST(MostToGain, onTheFeetTheRecordingInWhichTheChainIsOffMost) {
  const Mechanism leg = legOnItsFoot();
  std::vector<Trial> trials = legRecordings({});
  for (std::size_t k = 0; k < trials[4].cycles(); ++k) {
    const double wave = std::sin(0.1 * static_cast<double>(k));
    trials[3].signals[1].values[k] += 0.005 * wave;
    trials[4].signals[1].values[k] += 0.02 * wave;
  }
  const std::vector<char> atKnee =
      trialsWorthLooking(trials, leg, causeOf(leg, "coulomb_friction", "knee", 0.1));
  EXPECT_EQ(atKnee, (std::vector<char>{0, 0, 0, 0, 1}));
  EXPECT_EQ(trialsWorthLooking(trials, leg, groundSlope(0.02)), (std::vector<char>{0, 0, 0, 1, 1}));
}

}  // namespace plumbline::gap
