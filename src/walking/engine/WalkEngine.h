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
  /// Walk to this pose and stop there; in the robot's present frame, set again in every cycle; velocity and
  /// turn are ignored.
  std::optional<Pose2> target{};
  /// Kick with this foot in a step (section 4.4.1), at the target if there is one, as soon as it swings. One
  /// kick per request: clear `kick` before the next.
  std::optional<Side> kick{};
};

struct WalkOutput {
  JointArray angles{};  ///< targets [rad] of
  JointFlags set{};     ///< these joints: legs and arms, not the head
  Pose2 odometry;       ///< motion of the torso's ground frame since the last cycle, in that frame
  Support support = Support::both;
  Pose2 stepTarget;               ///< where the swing foot will land, in the frame of the centre of mass then
  double stepTime = 0;            ///< remaining time of the current step [s]
  double phase = 0;               ///< share of the current step that is over, 0 .. 1
  bool kicking = false;           ///< the step in progress is a kick
  bool kicked = false;            ///< the requested kick is over
  std::size_t stepsToTarget = 0;  ///< planned
  bool standing = true;           ///< both feet on the ground and at rest: another motion may begin
  Vec2 velocity = Vec2::Zero();   ///< present speed, mean over the step [m/s]
  double turn = 0;                ///< [rad/s]
  /// Both: forward, sideways, turn.
  Vec3 speed() const { return {velocity.x(), velocity.y(), turn}; }
  /// Share of the weight on the left foot.
  double leftShare() const { return support == Support::both ? 0.5 : support == Support::left ? 1 : 0; }
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

/// The walk of chapter 4 (Seekircher 2015). Every cycle corrects the walk state by the observation, plans the
/// current step with the pendulum model, and computes joint targets for one cycle. With
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
  /// Uses other parameters from the next cycle on, without a stop. Throws like the constructor, and then
  /// changes nothing.
  void setGaits(const WalkGaits& gaits);
  /// Stands from now on (after another motion moved the robot). Keeps what was learnt about its speeds.
  void reset();
  /// Forgets what was learnt about the robot's speeds (SpeedScale), as for another robot.
  void forget();
  /// Targets of the stand, with set as in WalkOutput.
  WalkOutput stand() const;
  /// The walk state that is being realised; for tests and plots.
  const WalkState& state() const;
  /// The plan of the present cycle, for drawings.
  WalkPlan plan() const;
  /// The observed state at the time of the last measurement; its velocity is the particle filter's.
  const WalkState& observed() const;
  /// The velocity from the movement of the support foot alone [m/s].
  Vec2 seenVelocity() const;
  /// The parameters at the present speed.
  const WalkParameters& gait() const;
  /// Mean difference of the torso's roll and pitch by IMU and by the supporting legs [rad].
  Vec2 imuDifference() const;
  /// How much of the walk is recovery from a push, 0 .. 1, and how far the observed capture point is from its
  /// usual place [m].
  double recovering() const;
  const Vec2& capturePointError() const;
  /// The target walk.
  const ReferenceTrajectory& reference() const;

  /// Sets the ten parameters that fit the model to this robot (section 4.3.1), from the next cycle on: one
  /// set for planning steps, one for filtering the observed state and predicting it over the delay.
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
