#pragma once
#include <optional>
#include <vector>

#include "tactics/approach/ApproachPlanner.h"
#include "tactics/approach/BallApproach.h"
#include "tactics/approach/WalkToPose.h"

namespace plumbline {

/// How a robot walks to the ball and stands there to play it (Seekircher 2015, 3.1.2).
struct BallPositioningParameters {
  PARAMETERS(BallPositioningParameters)
  PARAMETER_GROUP(WalkToPoseParameters, walk, "limits and gains of walking to a pose")
  PARAMETER_GROUP(BallApproachParameters, approach, "way around the ball")
  PARAMETER_GROUP(ApproachPlannerParameters, plan,
                  "the last metres to the ball, where the walk's limits are known")
  PARAMETER(double, toleranceForward, 0.02, "m", Range(0.001, 1), "of the ball's place ahead of the robot")
  PARAMETER(double, toleranceSideways, 0.02, "m", Range(0.001, 1), "of the ball's place to the side")
  PARAMETER(double, toleranceHeading, 0.15, "rad", Range(0.001, 3.2),
            "of the robot's heading, where the behaviour asks for no other")
  PARAMETER(double, leaveTolerances, 1.4, "", Range(1, 10),
            "a robot at the ball counts as there until its error is this many tolerances")
  PARAMETER(double, biasGain, 1.5, "1/s^2", Range(0, 10),
            "how fast a drift of the walk is learned near the target")
  PARAMETER(double, biasDistance, 0.15, "m", Range(0, 1),
            "closer to the target than this the drift is learned")
  PARAMETER(double, maxBias, 0.15, "m/s", Range(0, 1), "largest drift that is learned")
};

/// Walks to a place at the ball, cycle by cycle. All is in the robot's ground frame [m, rad].
class BallPositioning {
public:
  struct Wish {
    Vec2 ball = Vec2::Zero();   ///< where it is, or will be when the robot is there
    double heading = 0;         ///< of the robot when it plays the ball, relative to its present one
    Vec2 place = Vec2::Zero();  ///< where the ball has to lie then, in the frame that the robot has then
    double beyond = 0;  ///< a robot behind the ball, on its line, aims this far beyond the place, to dribble
    Vec3 speed = Vec3::Zero();                 ///< walked now: forward, sideways, turn [m/s, rad/s]
    WalkLimits limits{};                       ///< of the walk; not known: nothing is planned
    std::optional<Vec2> detour{};              ///< a way point that comes first
    double hurry = 1;                          ///< tolerances are multiplied by this
    std::optional<double> headingTolerance{};  ///< instead of the parameter's
  };

  /// A cycle of dt [s]. ball: where it is now [m]; decides atBall().
  WalkCommand update(const Wish& wish, const Vec2& ball, const BallPositioningParameters& p, double dt);
  /// The robot stands exactly enough. From then on a larger error is allowed (`keeps`): a walk that
  /// alternates between stopping and walking never comes to rest.
  bool atBall() const { return atBall_; }
  /// No ball is wanted in this cycle. What was learned of the walk's drift stays.
  void leave() {
    atBall_ = sprinting_ = false;
    planner_.leave();
  }
  const ApproachPlanner& planner() const { return planner_; }

  /// Where the robot shall stand, in its present frame.
  static Pose2 placeOf(const Wish& wish);
  /// The planned way there in the frame of that place; empty if nothing is planned. For drawings.
  std::vector<Pose2> plannedWay(const Wish& wish, const BallPositioningParameters& p) const;

private:
  bool exact(const Wish& wish, const Vec2& error, const BallPositioningParameters& p) const;
  void learnBias(const Pose2& T_robot_target, const BallPositioningParameters& p, double dt);

  ApproachPlanner planner_;
  Vec2 bias_ = Vec2::Zero();  ///< the walk's, near the target, as a correction of the speed [m/s]
  bool atBall_ = false, sprinting_ = false;
};

}  // namespace plumbline
