#include "tactics/approach/ApproachPlanner.h"

#include <algorithm>
#include <cmath>

#include "math/BrakingSpeed.h"

namespace plumbline {
namespace {

constexpr double modelStep = 0.06;  ///< of a simulated way [s]
constexpr double longestWay = 12;   ///< [s]
constexpr int choiceEvery = 3;      ///< cycles
constexpr double turnBefore = 0.1;  ///< the last turn takes this much longer than at full rate [s]
constexpr double nearPlace = 0.12;  ///< here the robot has its last heading [m]
constexpr double leastWalk = 0.2;   ///< share of the speed that remains in the fastest turn
constexpr double atPlace = 0.03, atHeading = 0.15, atRest = 0.2;  ///< the way is over [m, rad, m/s]
constexpr double touchDistance = 0.16;  ///< the feet may touch a ball that is so near [m]

const Vec2 farAway(1e3, 0);  ///< a ball that is in nobody's way [m]

/// One way to the place, and the robot's walk on it.
struct Way {
  const Vec2& ball;
  double beyond;
  const WalkLimits& limits;
  const ApproachPlannerParameters& p;
  Facing facing;
  Around side;

  double bodyHeading(const WalkPoint& robot, const BallPath& path, double direction) const;
  Vec3 request(const WalkPoint& robot) const;
  bool over(const WalkPoint& robot) const;
  double seconds(WalkPoint robot, double most) const;
};

double Way::bodyHeading(const WalkPoint& robot, const BallPath& path, double direction) const {
  double speed = limits.forward;
  if (facing == Facing::backward) speed = limits.backward;
  if (facing == Facing::toBall) speed = limits.sideways;
  const double turn = std::abs(robot.pose.heading) / (p.turnShare * limits.turn) + turnBefore;
  if (facing == Facing::asAtEnd || path.length < nearPlace || path.length / speed < p.finalTurn * turn)
    return 0;
  if (facing == Facing::toBall) {
    const Vec2 toBall = ball - robot.pose.position;
    return std::atan2(toBall.y(), toBall.x());
  }
  return facing == Facing::forward ? direction : direction + pi;
}

Vec3 Way::request(const WalkPoint& robot) const {
  BallPath path = pathToPlace(robot.pose.position, ball, side, p.path);
  if (path.last && beyond > 0) {
    path.next.x() = beyond;
    path.length = (path.next - robot.pose.position).norm();
  }
  const Vec2 way = path.next - robot.pose.position;
  const double direction = std::atan2(way.y(), way.x());
  const double error = normalizeAngle(bodyHeading(robot, path, direction) - robot.pose.heading);
  const double turn = std::copysign(
      std::min(p.turnShare * limits.turn,
               brakingSpeed(std::abs(error), p.brakeShare * limits.accelerationTurn, p.headingTime)),
      error);
  if (way.norm() < 1e-9) return {0, 0, turn};
  const Vec2 along(std::cos(direction - robot.pose.heading), std::sin(direction - robot.pose.heading));
  const double fastest = 1 / std::hypot(along.x() / (along.x() >= 0 ? limits.forward : limits.backward),
                                        along.y() / limits.sideways);
  const double walkShare = std::sqrt(std::max(leastWalk * leastWalk, 1 - std::pow(turn / limits.turn, 2)));
  const double deceleration = p.brakeShare / std::hypot(along.x() / limits.decelerationForward,
                                                        along.y() / limits.accelerationSideways);
  const double speed =
      std::min(p.speedShare * walkShare * fastest, brakingSpeed(path.length, deceleration, p.brakeTime));
  return {speed * along.x(), speed * along.y(), turn};
}

bool Way::over(const WalkPoint& robot) const {
  const Vec2& at = robot.pose.position;
  const bool there = beyond > 0 ? at.x() > -atPlace && std::abs(at.y()) < atPlace
                                : at.norm() < atPlace && robot.speed.head<2>().norm() < atRest;
  return there && std::abs(robot.pose.heading) < atHeading;
}

double Way::seconds(WalkPoint robot, double most) const {
  double cost = 0;
  while (cost < most) {
    if (over(robot)) return cost;
    robot = walked(robot, request(robot), limits, modelStep);
    cost += modelStep;
    if ((robot.pose.position - ball).norm() < touchDistance) cost += p.ballCost * modelStep;
  }
  return most;
}

}  // namespace

WalkCommand ApproachPlanner::update(const WalkPoint& robot, const Vec2& ball, double beyond,
                                    const WalkLimits& limits, const ApproachPlannerParameters& parameters) {
  const WalkPoint later = coasted(robot, parameters.delay);
  const auto way = [&](Facing facing, Around side) {
    return Way{ball, beyond, limits, parameters, facing, side};
  };
  if (!planned_ || ++cycle_ >= choiceEvery) {
    double best =
        planned_ ? way(facing_, side_).seconds(later, longestWay) - parameters.switchGain : longestWay;
    const bool straight = pathToPlace(later.pose.position, ball, side_, parameters.path).last;
    for (const Facing facing : {Facing::forward, Facing::backward, Facing::asAtEnd, Facing::toBall})
      for (const Around side : {Around::clockwise, Around::counterclockwise}) {
        if (straight && side != side_) continue;  // both are the same
        const double seconds = way(facing, side).seconds(later, best);
        if (seconds >= best) continue;
        best = seconds;
        facing_ = facing;
        side_ = side;
      }
    seconds_ = best;
    planned_ = true;
    cycle_ = 0;
  }
  const Vec3 request = way(facing_, side_).request(later);
  return {.velocity = request.head<2>(), .turn = request.z()};
}

WalkCommand ApproachPlanner::update(const WalkPoint& robot, const WalkLimits& limits,
                                    const ApproachPlannerParameters& parameters) {
  return update(robot, farAway, 0, limits, parameters);
}

std::vector<Pose2> ApproachPlanner::way(const WalkPoint& robot, const Vec2& ball, double beyond,
                                        const WalkLimits& limits,
                                        const ApproachPlannerParameters& parameters) const {
  std::vector<Pose2> poses;
  if (!planned_) return poses;
  const Way way{ball, beyond, limits, parameters, facing_, side_};
  WalkPoint walker = coasted(robot, parameters.delay);
  while (static_cast<double>(poses.size()) * modelStep < longestWay) {
    poses.push_back(walker.pose);
    if (way.over(walker)) break;
    walker = walked(walker, way.request(walker), limits, modelStep);
  }
  return poses;
}

}  // namespace plumbline
