#pragma once
#include "robot/ForwardKinematics.h"
#include "robot/LegKinematics.h"
#include "walking/estimation/ContactVelocity.h"
#include "walking/estimation/WalkSensors.h"

namespace plumbline::walking {

/// The observed walk state (section 4.2.5). The feet come from the joint angles and the torso's angles, the
/// velocity from the particle filter. That filter uses the forces on the feet if they are measured, else the
/// movement of the commanded support feet. The state is as old as the measurement.
class WalkObserver {
public:
  explicit WalkObserver(const RobotModel& robot, const VelocityFilterParameters& filter = {});
  WalkObserver(const WalkObserver&) = delete;
  WalkObserver& operator=(const WalkObserver&) = delete;

  void reset();
  /// A measurement; `support` and `action` are what went on since the last one, in the model. average: time
  /// over which the difference of IMU and legs is averaged [s]; 0: it is not taken off the IMU's angles.
  void update(const WalkSensors& sensors, Support support, const WalkAction& action, const WalkModel& model,
              double average);

  const WalkState& state() const { return observed_; }
  /// Torso against gravity, roll and pitch, without the mean difference of IMU and legs [rad].
  const Vec2& torsoAngles() const { return angles_; }
  /// Mean difference of the torso's roll and pitch by the IMU and by the supporting legs (section 4.2.8,
  /// table 4.1) [rad].
  const Vec2& imuDifference() const { return difference_; }
  /// Velocity of the centre of mass by the movement of what touches the ground, or of the commanded foot,
  /// alone, last cycle [m/s].
  const Vec2& seenVelocity() const { return seen_; }

  /// Motion of the torso's ground frame in the last cycle, in that frame. The motion of the centre of mass
  /// comes from the given velocity, that of the torso relative to it from the joints, the heading from the
  /// gyrometer.
  const Pose2& torsoMotion() const { return torsoMoved_; }

private:
  Vec2 legAngles(Support support) const;
  double watchFeet(const WalkState& before, Support support, double dt);

  RobotModel robot_;
  ForwardKinematics kinematics_;
  std::array<LegKinematics, 2> legs_;
  std::array<Pose3, 2> soles_;  ///< in the torso frame
  ContactVelocity contacts_;
  VelocityFilter filter_;
  WalkState observed_;
  Vec2 angles_ = Vec2::Zero(), difference_ = Vec2::Zero(), seen_ = Vec2::Zero();
  Vec2 torsoPlace_ = Vec2::Zero();  ///< over the ground in the frame of the centre of mass [m]
  Pose2 torsoMoved_;
  bool begun_ = false;
};

}  // namespace plumbline::walking
