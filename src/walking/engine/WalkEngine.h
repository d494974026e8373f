#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "math/Pose2.h"
#include "robot/RobotModel.h"
#include "walking/estimation/ObservedStep.h"
#include "walking/estimation/WalkSensors.h"
#include "walking/model/WalkState.h"
#include "walking/parameters/WalkGaits.h"
#include "walking/planning/ReferenceTrajectory.h"

namespace plumbline::walking {

struct WalkRequest {
  Vec2 velocity = Vec2::Zero();  ///< in the robot's frame, clipped to what the parameters allow [m/s]
  double turn = 0;               ///< [rad/s], counterclockwise
  bool walk = false;             ///< false: come to a safe stop and stand
  /// Walk to this pose and stop there; in the robot's frame now, told anew every cycle; velocity and turn do
  /// not matter.
  std::optional<Pose2> target{};
  /// Kick with this foot in a step (section 4.4.1), at the target if there is one, as soon as it swings; once
  /// until it is not asked for any more.
  std::optional<Side> kick{};
};

struct WalkOutput {
  JointArray angles{};  ///< targets [rad] of
  JointFlags set{};     ///< these joints: legs and arms, not the head
  Pose2 odometry;       ///< motion of the torso's ground frame since the last cycle, in that frame
  Support support = Support::both;
  Pose2 stepTarget;               ///< where the swing foot will land, in the frame of the centre of mass then
  double stepTime = 0;            ///< left of the current step [s]
  double phase = 0;               ///< passed share of the current step, 0 .. 1
  bool kicking = false;           ///< the step in progress is a kick
  bool kicked = false;            ///< the kick that is asked for is over
  std::size_t stepsToTarget = 0;  ///< planned
  bool standing = true;           ///< both feet on the ground and at rest: another motion may begin
  Vec2 velocity = Vec2::Zero();   ///< walked now, mean over the step [m/s]
  double turn = 0;                ///< [rad/s]
  /// Joint stiffness (section 4.2.6), 0 .. 1, for robots that have it; all 0 while falling.
  JointArray stiffness = fullStiffness();
  bool falling = false;  ///< cannot be stopped any more (FallGuard); until reset() or at rest upright

  static constexpr JointArray fullStiffness() {
    JointArray all{};
    for (double& one : all) one = 1;
    return all;
  }
  /// Of both legs alike; full everywhere else.
  static JointArray legStiffness(double hip, double knee, double ankle) {
    JointArray all = fullStiffness();
    const std::array<double, 6> leg{hip, hip, hip, knee, ankle, ankle};
    for (const Side side : {Side::left, Side::right})
      std::ranges::copy(leg, all.begin() + firstLegJoint(side));
    return all;
  }
};

struct WalkPlan {
  Pose2
      landing;  ///< of the swing foot, in the supporting foot's frame; before a step is planned: where it is
  Pose2 torso;  ///< on the ground, in the frame of the walk state
};

/// The walk of chapter 4 (Seekircher 2015): every cycle the walk state is drawn to what is observed, the step
/// in progress is planned with the pendulum model, and one cycle of it becomes joint targets. With
/// observation.positionGain and velocityGain at 0 it is the open loop of section 4.2.4. Call update() once
/// per control cycle.
class WalkEngine {
public:
  /// Throws std::invalid_argument for parameters out of range (naming the parameter) or a robot whose legs it
  /// cannot move.
  WalkEngine(const WalkGaits& gaits, const RobotModel& robot);
  WalkEngine(const WalkParameters& parameters, const RobotModel& robot)
      : WalkEngine(WalkGaits(parameters), robot) {}
  ~WalkEngine();
  WalkEngine(WalkEngine&&) noexcept;
  WalkEngine& operator=(WalkEngine&&) noexcept;

  WalkOutput update(const WalkRequest& request, const WalkSensors& sensors);
  /// Other parameters from the next cycle on, without a stop. Throws as the constructor, and changes nothing
  /// then.
  void setGaits(const WalkGaits& gaits);
  /// Stands from now on (after another motion moved the robot). What was learnt of its speeds stays.
  void reset();
  /// Forgets what was learnt of the robot's speeds (SpeedScale), as for another robot.
  void forget();
  /// Targets of the stand, with set as in WalkOutput.
  WalkOutput stand() const;
  /// The walk state that is being realised; for tests and plots.
  const WalkState& state() const;
  /// What the present cycle leads to; for drawings.
  WalkPlan plan() const;
  /// What is observed, as old as the last measurement; its velocity is the particle filter's.
  const WalkState& observed() const;
  /// The velocity that the supporting foot's movement alone shows [m/s].
  Vec2 seenVelocity() const;
  /// The parameters at the present speed.
  const WalkParameters& gait() const;
  /// Mean difference of the torso's roll and pitch by IMU and by the supporting legs [rad].
  Vec2 imuDifference() const;
  /// How much of the walk is recovery from a push, 0 .. 1, and how far the observed capture point is from its
  /// usual place [m].
  double recovering() const;
  const Vec2& capturePointError() const;
  /// The walk that is aimed at.
  const ReferenceTrajectory& reference() const;

  /// The ten parameters that fit the model to this robot (section 4.3.1), from the next cycle on: those that
  /// steps are planned with, and those by which the observed state is filtered and carried over the delay.
  void setModelParameters(const ModelParameters& parameters);
  const ModelParameters& modelParameters() const;
  void setPrediction(const ModelParameters& parameters);
  const ModelParameters& prediction() const;
  /// The observed step that ended in the last update, if one did (nullptr); valid until the next update.
  const ObservedStep* observedStep();

private:
  class Implementation;
  std::unique_ptr<Implementation> engine_;
};

}  // namespace plumbline::walking
