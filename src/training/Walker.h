#pragma once
#include <cmath>
#include <functional>

#include "math/GroundPose.h"
#include "math/Pose2.h"
#include "walking/engine/WalkEngine.h"

namespace plumbline::training {

/// A robot in a world of its own that walks with the engine, whatever robot and whatever physics: what
/// training, tests and benchmarks see of it.
class Walker {
public:
  virtual ~Walker() = default;
  Walker(const Walker&) = delete;
  Walker& operator=(const Walker&) = delete;

  /// Walks with other parameters from now on, standing.
  void use(const walking::WalkGaits& gaits) {
    engine = walking::WalkEngine(gaits, model);
    restart();
  }

  /// Stands at a place of the ground, as a robot that has never walked.
  void restart(const Pose2& place = {}) {
    engine.forget();
    putBack(place);
  }
  /// Stands there, and keeps what it has learnt of its speed.
  void putBack(const Pose2& place = {}) {
    engine.reset();
    put(place, engine.stand().angles);
    lastPose_ = pose();
    turned_ = 0;
  }

  /// One cycle; false when the robot lies.
  bool step(const walking::WalkRequest& request) {
    if (interrupt) interrupt();
    const walking::WalkSensors sensors = sense();
    output = engine.update(request, sensors);
    act(output, sensors);
    const Pose2 now = pose();
    moved = lastPose_.inverse() * now;
    turned_ += moved.heading;
    lastPose_ = now;
    return !fallen();
  }
  /// Many cycles; false as soon as the robot lies.
  bool run(const walking::WalkRequest& request, double seconds) {
    for (long i = std::lround(seconds / cycle); i > 0; --i)
      if (!step(request)) return false;
    return true;
  }

  /// Whether it can be carried.
  virtual bool carries() const { return true; }
  /// Goes on walking at another place, heading as before.
  void carry(const Vec2& place) {
    move(place);
    lastPose_ = pose();
  }
  /// A push on the robot within the coming cycle that changes its momentum by its mass times this
  /// [m/s, world].
  virtual void push(const Vec3& change) = 0;

  virtual Pose3 torso() const = 0;
  /// Place of the torso over the ground.
  Pose2 pose() const { return groundPose(torso()); }
  /// Whether the torso leans by more than 60 degrees.
  bool fallen() const { return torso().linear()(2, 2) < 0.5; }
  /// True velocity of the centre of mass over the ground, in the torso's heading [m/s].
  virtual Vec2 comVelocity() = 0;
  double turned() const { return turned_; }  ///< since the restart, without wrapping [rad]

  const RobotModel model;
  const double cycle;  ///< of control [s]
  walking::WalkEngine engine;
  std::function<void()> interrupt;  ///< called each cycle; what it throws ends the walk
  walking::WalkOutput output;
  Pose2 moved;  ///< in the last cycle

protected:
  Walker(const RobotModel& robot, const walking::WalkGaits& gaits, double cycle)
      : model(robot), cycle(cycle), engine(gaits, model) {}

  /// Targets with a head that looks around, as a player's does; time [s].
  static JointArray lookingAround(JointArray targets, double time) {
    targets[headYaw] = 1.2 * std::sin(2 * time);
    targets[headPitch] = 0.3 * std::sin(3.1 * time);
    return targets;
  }

private:
  virtual void put(const Pose2& place, const JointArray& angles) = 0;
  virtual void move(const Vec2& place) = 0;
  virtual walking::WalkSensors sense() = 0;
  /// Commands what the engine says and lets a cycle pass.
  virtual void act(const walking::WalkOutput& output, const walking::WalkSensors& sensors) = 0;

  Pose2 lastPose_;
  double turned_ = 0;
};

}  // namespace plumbline::training
