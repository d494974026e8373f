#pragma once
#include "robot/ForwardKinematics.h"
#include "robot/LegKinematics.h"
#include "walking/model/WalkState.h"

namespace plumbline::walking {

/// A foot in the frame of the centre of mass: sole's centre and heading, height over the ground and tilt.
struct FootPlacement {
  Pose2 ground;
  double height = 0;  ///< [m]
  double pitch = 0;   ///< toes down positive [rad]
  double roll = 0;    ///< right edge down positive [rad]
};

/// How the torso is carried.
struct TorsoPlacement {
  double hipHeight = 0.2;      ///< middle of the hips over the ground [m]
  double roll = 0, pitch = 0;  ///< lean right, forward [rad]
};

/// Joint angles from the walk state: the torso is put where the centre of mass of the whole robot, swing leg
/// and arms included, comes over the frame's origin. Each call begins from the result of the last; allocates
/// nothing. Hips that share a yaw pitch motor turn by the mean of the angles that the feet need; the feet's
/// headings have the remaining error.
class BodyPosture {
public:
  explicit BodyPosture(const RobotModel& robot);
  BodyPosture(const BodyPosture&) = delete;
  BodyPosture& operator=(const BodyPosture&) = delete;

  /// Writes the leg joints of `angles`; the other joints in it are taken as they are. Returns whether both
  /// feet can be reached; if not they come as near as they can.
  bool solve(const std::array<FootPlacement, 2>& feet, const TorsoPlacement& torso, JointArray& angles);

  /// Where solve() put the torso: its frame in that of the centre of mass (z from the ground).
  const Pose3& torso() const { return T_com_torso_; }
  /// Of the centre of mass over the ground there [m].
  double comHeight() const { return (T_com_torso_ * kinematics_.com()).z(); }
  const LegKinematics& leg(Side side) const { return legs_[index(side)]; }
  /// Forgets the last result.
  void reset() { offset_.setZero(); }

private:
  RobotModel robot_;
  ForwardKinematics kinematics_;
  std::array<LegKinematics, 2> legs_;
  Vec2 offset_ = Vec2::Zero();  ///< of the torso's origin from the centre of mass, over the ground [m]
  Pose3 T_com_torso_ = Pose3::Identity();
};

}  // namespace plumbline::walking
