#pragma once
#include <array>
#include <memory>

#include "math/Pose2.h"
#include "robot/RobotModel.h"
#include "walking/WalkParameters.h"
#include "walking/WalkState.h"

namespace plumbline::walking {

struct WalkRequest {
  Vec2 velocity = Vec2::Zero();  ///< in the robot's frame, clipped to what the parameters allow [m/s]
  double turn = 0;               ///< [rad/s], counterclockwise
  bool walk = false;             ///< false: come to a safe stop and stand
};

struct WalkSensors {
  JointArray angles{};                ///< measured [rad]
  Vec2 torsoAngles = Vec2::Zero();    ///< torso against gravity: roll (about x) and pitch (about y) [rad]
  Vec3 gyro = Vec3::Zero();           ///< torso frame [rad/s]
  std::array<double, 2> footForce{};  ///< vertical force on the left and right sole [N]
  double dt = 0.02;                   ///< of one cycle [s]
};

struct WalkOutput {
  JointArray angles{};                ///< targets [rad] of
  std::array<bool, numJoints> set{};  ///< these joints: legs and arms, not the head
  Pose2 odometry;  ///< motion of the torso's ground frame since the last cycle, in that frame
  Support support = Support::both;
  double phase = 0;              ///< passed share of the current step, 0 .. 1
  bool standing = true;          ///< both feet on the ground and at rest: another motion may begin
  Vec2 velocity = Vec2::Zero();  ///< walked now, mean over the step [m/s]
  double turn = 0;               ///< [rad/s]
};

/// The walk of chapter 4 (Seekircher 2015), sections 4.2.1 to 4.2.4: every cycle the step in progress is
/// planned with the pendulum model and one cycle of it becomes joint targets. Call update() once per control
/// cycle.
class WalkEngine {
public:
  /// Throws std::invalid_argument for parameters out of range (naming the parameter) or a robot whose legs it
  /// cannot move.
  WalkEngine(const WalkParameters& parameters, const RobotModel& robot);
  ~WalkEngine();
  WalkEngine(WalkEngine&&) noexcept;

  WalkOutput update(const WalkRequest& request, const WalkSensors& sensors);
  /// Stands from now on (after another motion moved the robot).
  void reset();
  /// Targets of the stand, with set as in WalkOutput.
  WalkOutput stand() const;
  /// The walk state that is being realised; for tests and plots.
  const WalkState& state() const;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation;
};

}  // namespace plumbline::walking
