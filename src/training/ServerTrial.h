#pragma once
#include "simulation/league/LocalRobot.h"
#include "training/MotionDriver.h"
#include "training/ServerRobot.h"

namespace plumbline::training {

/// A robot of a SimSpark server, the league's or bin/simulator, that is moved by motions and walk. The walk
/// feels the torso's lean by gyro and accelerometer, as a player does. Errors are ServerRobot's.
class ServerTrial : public MotionDriver {
public:
  ServerTrial(int type, const SimSparkAddress& address)
      : MotionDriver(type), robot(type, address), twin_(model) {}

  const simulation::RobotReadings& readings() const override { return robot.readings(); }
  Pose3 torsoPose() const override { return robot.torso(); }

  /// Stands at rest at a place, and nothing of what was before has an effect.
  void standAt(const Pose2& place);
  /// Falls forward (1) or backward (-1): it is dropped with its joints anywhere near the walk's, leaning at
  /// its ankles, and falls until it has lain for a moment. False if it did not fall that way, or if its limbs
  /// passed through each other meanwhile: the referee would have frozen them, as the draw put them anywhere.
  bool fall(int direction);

  ServerRobot robot;

private:
  void move(const JointArray& targets) override { robot.drive(targets); }
  /// Whether limbs pass through each other, which no server tells.
  bool overlaps();
  Vec3 feltUp() const override { return robot.attitude().up(); }

  simulation::LocalRobot twin_;  ///< in the same pose
};

}  // namespace plumbline::training
