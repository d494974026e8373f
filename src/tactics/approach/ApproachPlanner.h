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
  PARAMETER(double, sprintDistance, 1.2, "m", Range(0, 20),
            "a robot that sprints goes on until it is nearer than this")
  PARAMETER_GROUP(BallApproachParameters, path, "around the ball")
  PARAMETER(double, delay, 0.14, "s", Range(0, 0.5), "from a request of the walk to its effect")
  PARAMETER(double, speedShare, 1.16, "", Range(0.5, 2),
            "share of the walk's limits of speed that is asked for")
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

/// Which way the body faces on the way: along it, against it, as at its end, or to the ball. At the end it
/// always turns to its last heading.
enum class Facing { forward, backward, asAtEnd, toBall };

/// Chooses how to walk to a place at the ball: on which side around the ball, and which way the body faces.
/// Each choice is simulated to its end with a model of the walk, and the one that is there first is walked
/// (rollout of given policies: Bertsekas, Tsitsiklis and Wu, J. Heuristics 3, 1997). The choice is made anew
/// every third cycle.
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

  bool plans() const { return planned_; }  ///< the last cycle was planned
  /// The way that was chosen, as simulated from a cycle's robot on: poses every 0.06 s, at most 12 s; empty
  /// if nothing is planned. For drawings.
  std::vector<Pose2> way(const WalkPoint& robot, const Vec2& ball, double beyond, const WalkLimits& limits,
                         const ApproachPlannerParameters& parameters) const;
  Facing facing() const { return facing_; }
  Around side() const { return side_; }
  double seconds() const { return seconds_; }  ///< until the robot is there, as planned [s]

private:
  bool planned_ = false;
  int cycle_ = 0;  ///< since the last choice
  Facing facing_ = Facing::forward;
  Around side_ = Around::clockwise;
  double seconds_ = 0;
};

}  // namespace plumbline
