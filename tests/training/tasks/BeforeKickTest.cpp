#include "training/tasks/BeforeKick.h"

#include <gtest/gtest.h>

#include "training/MotionTrial.h"

namespace plumbline::training {
namespace {

TEST(BeforeKick, aRobotComesToRestAfterAWalkOrASway) {
  MotionTrial trial(4);
  int came = 0, walked = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    trial.robot.restart(Pose2(), trial.stand);
    trial.restarted();
    trial.seed(seed);
    if (!comesToKick(trial)) continue;
    ++came;
    walked += trial.torsoPose().translation().head<2>().norm() > 0.05;
    EXPECT_LT(trial.tilt(), 0.3);
    EXPECT_FALSE(trial.lying());
  }
  EXPECT_GE(came, 18);
  EXPECT_GE(walked, 6);
  EXPECT_LE(walked, 18);
}

/// Stands, but leans as far as one that falls.
class LeaningPuppet : public MotionDriver {
public:
  LeaningPuppet() : MotionDriver(4) { sensed_.angle = stand; }
  const simulation::RobotReadings& readings() const override { return sensed_; }
  Pose3 torsoPose() const override { return translation(0, 0, 0.4) * rotationY(lean); }
  Vec3 feltUp() const override { return Vec3::UnitZ(); }
  double lean = 0;

private:
  void move(const JointArray& targets) override { sensed_.angle = targets; }
  simulation::RobotReadings sensed_;
};

TEST(BeforeKick, aRobotThatLeansFarDoesNotComeToAKickThoughItsWalkHasStopped) {
  int upright = 0, leaning = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    for (const double lean : {0.0, 0.7}) {
      LeaningPuppet robot;
      robot.lean = lean;
      robot.seed(seed);
      (lean > 0 ? leaning : upright) += comesToKick(robot);
    }
  }
  EXPECT_EQ(upright, 10);
  EXPECT_EQ(leaning, 0);
}

}  // namespace
}  // namespace plumbline::training
