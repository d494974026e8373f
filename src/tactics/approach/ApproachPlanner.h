#pragma once
#include <vector>

#include "tactics/approach/BallPath.h"
#include "tactics/approach/WalkForecast.h"
#include "tactics/approach/WalkToPose.h"

namespace plumbline {

/// How a robot walks the last metres to its place at the ball.
struct ApproachPlannerParameters {
  PARAMETERS(ApproachPlannerParameters)
  PARAMETER(double, distance, 2, "m", Range(0, 20), "nearer than this the way is planned, 0: never")
  PARAMETER(double, sprintDistance, 1.2, "m", Range(0, 20), "in a sprint nearer than this; it is soon over")
  PARAMETER_GROUP(BallPathParameters, path, "around the ball")
  PARAMETER(double, delay, 0.14, "s", Range(0, 0.5), "from a request of the walk to its effect")
  PARAMETER(double, request, 1.16, "", Range(0.5, 2),
            "speeds that are asked for, as a share of the walk's limits")
  PARAMETER(double, brakeShare, 0.78, "", Range(0.1, 2), "share of the walk's decelerations that is used")
  PARAMETER(double, brakeTime, 0.3, "s", Range(0.02, 2), "by which it brakes early")
  PARAMETER(double, headingTime, 0.05, "s", Range(0.02, 2), "by which it stops turning early")
  PARAMETER(double, turnShare, 0.83, "", Range(0.1, 1), "share of the walk's fastest turn that is used")
  PARAMETER(double, finalTurn, 0.46, "", Range(0.1, 5),
            "the last turn begins when the way takes so many times as long as the turn")
  PARAMETER(double, switchGain, 0.08, "s", Range(0, 2), "another way has to be faster by so much")
  PARAMETER(double, ballCost, 0.8, "", Range(0, 20),
            "time beside the ball, where it may be touched, counts so much more")
};

/// Which way the body faces on the way. At its end it always turns to its last heading.
enum class Facing { forward, backward, goal, ball };

/// Chooses how to walk to a place at the ball: on which side around the ball, and which way the body faces.
/// Each choice is simulated to its end with a model of the walk, and the one that is there first is walked
/// (rollout of given policies: Bertsekas, Dynamic Programming and Optimal Control, 6.4). The choice is made
/// anew every third cycle.
///
/// Frame of everything here: the pose that the robot shall have, x where it will face [m, rad].
class ApproachPlanner {
public:
  /// The walk's request of a cycle. robot: its heading within -pi .. pi. ball: the one beside the place.
  /// beyond: the robot need not stop before it is this far beyond the place along x [m].
  WalkCommand update(const WalkPoint& robot, const Vec2& ball, double beyond, const WalkLimits& limits,
                     const ApproachPlannerParameters& parameters);
  /// The same to a place without a ball.
  WalkCommand update(const WalkPoint& robot, const WalkLimits& limits,
                     const ApproachPlannerParameters& parameters);
  /// Whether the way is planned from this far away [m]; sprinting: the robot does, in the cycle before.
  static bool plansFrom(double distance, bool sprinting, const WalkLimits& limits,
                        const ApproachPlannerParameters& parameters) {
    return limits.known() && distance < (sprinting ? parameters.sprintDistance : parameters.distance);
  }
  /// Nothing is planned in this cycle: the next plan begins anew.
  void leave() { planned_ = false; }

  /// Whether the last cycle was planned, and its way as simulated: poses every 0.06 s, at most 12 s. For
  /// drawings.
  bool plans() const { return planned_; }
  std::vector<Pose2> way(const WalkLimits& limits, const ApproachPlannerParameters& parameters) const;
  Facing facing() const { return facing_; }
  Around side() const { return side_; }
  double seconds() const { return seconds_; }  ///< until the robot is there, as planned [s]

private:
  bool planned_ = false;
  WalkPoint robot_;  ///< of the last cycle, when its request has an effect
  Vec2 ball_ = Vec2::Zero();
  double beyond_ = 0;
  int cycle_ = 0;  ///< since the last choice
  Facing facing_ = Facing::forward;
  Around side_ = Around::clockwise;
  double seconds_ = 0;
};

}  // namespace plumbline
