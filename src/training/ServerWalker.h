#pragma once
#include "training/ServerRobot.h"
#include "training/Walker.h"

namespace plumbline::training {

/// A robot of a SimSpark server as a walker: it senses and acts like a player, and the trainer moves it to
/// its places. Errors are ServerRobot's.
class ServerWalker : public Walker {
public:
  ServerWalker(int type, const walking::WalkGaits& gaits, const SimSparkAddress& address);

  /// No server pushes or carries robots: throws std::logic_error.
  void push(const Vec3& change) override;
  /// Whom a trainer moves has lost its speed.
  bool carries() const override { return false; }
  Pose3 torso() const override { return robot_.torso(); }
  /// The monitor's poses are too coarse for it: throws std::logic_error.
  Vec2 comVelocity() override;

private:
  void put(const Pose2& place, const JointArray& angles) override { robot_.put(place, angles); }
  void move(const Vec2& place) override;
  walking::WalkSensors sense() override;
  void act(const walking::WalkOutput& output, const walking::WalkSensors& sensors) override;

  ServerRobot robot_;
};

}  // namespace plumbline::training
