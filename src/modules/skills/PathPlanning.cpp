#include "modules/skills/PathPlanning.h"

#include <algorithm>
#include <cmath>

#include "framework/DrawingSite.h"
#include "tactics/RollingBall.h"

namespace plumbline {

MAKE_MODULE(PathPlanning)

PathPlanning::Destination PathPlanning::destination() const {
  const SkillOutput* skill = findSkill(allSkillOutputs, theSkillRequest->skill);
  if (!skill) return Destination::none;
  if (skill->goesToTarget) return Destination::place;
  return skill->approach == BallApproach::none ? Destination::none : Destination::ball;
}

Obstacles PathPlanning::obstacles(Destination to, const Vec2& goal) const {
  Obstacles all;
  std::vector<Obstacle>& found = all.circles;
  const Vec2& own = theRobotPose->pose.position;
  for (const OtherRobot& robot : theOtherRobots->robots) {
    if (theFrameInfo->time - robot.lastSeen > oldestSight) continue;
    const Vec2& ball = theBallPos->field;
    if (to == Destination::ball && (robot.position - ball).norm() < destinationRadius) continue;
    const double seconds = std::min((robot.position - own).norm() / ownSpeed, foresight);
    found.push_back({robot.position + seconds * robot.velocity, robot.fallen ? fallenRadius : robotRadius});
  }
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      found.push_back({{x * theFieldDimensions->length, y * theFieldDimensions->goalWidth}, postRadius});
  if (to == Destination::place && theBallPos->valid) found.push_back({theBallPos->field, ballRadius});
  if (!thePlayerRole->mayBeInOwnArea) {
    const OwnArea area(theFieldDimensions->size());
    const double margin = std::min({OwnArea::passDistance, area.distance(own), area.distance(goal)});
    if (margin > 0) all.closed = area.widened(margin);
  }
  return all;
}

bool PathPlanning::mateGoesBefore(const Vec2& direction) const {
  if (thePlayerRole->role == PlayerRole::striker) return false;
  const Vec2& own = theRobotPose->pose.position;
  return std::ranges::any_of(theOtherRobots->robots, [&](const OtherRobot& robot) {
    if (!robot.mate || robot.fallen || theFrameInfo->time - robot.lastSeen > oldestSight) return false;
    if (robot.number > thePlayerInfo->number && robot.number != thePlayerRole->strikerNumber) return false;
    const Vec2 way = robot.position - own;
    return way.norm() < waitDistance && way.dot(direction) > 0.5 * way.norm();
  });
}

/// What must not be walked into, and the way round it.
void PathPlanning::drawWay(Drawing& drawing, const Vec2& goal, const Obstacles& all) const {
  constexpr double corridor = 3;  // obstacles farther from the way are left out [m]
  constexpr int most = 30;        // more than there are in a game
  const Vec2& own = theRobotPose->pose.position;
  int drawn = 0;
  for (const Obstacle& obstacle : all.circles)
    if (distanceToSegment(obstacle.centre, own, goal) < corridor && drawn++ < most)
      drawing.circle(obstacle.centre, obstacle.radius, colours::faint(colours::red, 0.6), 1);
  Vec2 from = own;
  for (const Vec2& corner : shortestWay(own, goal, all, last_, planner)) {
    drawing.line(from, corner, colours::green, 2);
    from = corner;
  }
  drawing.point(goal, colours::green, 8);
}

void PathPlanning::update(SafeWalkDirection* theSafeWalkDirection) {
  SafeWalkDirection& safe = *theSafeWalkDirection;
  safe = SafeWalkDirection();
  const Destination to = destination();
  if (to == Destination::none || !theRobotPose->valid || (to == Destination::ball && !theBallPos->valid)) {
    last_.setZero();
    return;
  }
  const Pose2& robot = theRobotPose->pose;
  const Vec2 goal = to == Destination::ball ? meetingPlace(robot.position, ownSpeed, theBallPos->field,
                                                           robot.rotation() * theBallPos->relativeVelocity)
                                            : theSkillRequest->target.position;
  const Obstacles all = obstacles(to, goal);
  const Vec2 wayPoint = nextWayPoint(robot.position, goal, all, last_, planner);
  DEBUG_DRAWING("draw:team:way", drawWay(drawing, goal, all);
                drawing.arrow(robot.position, wayPoint, colours::green, 3));
  const Vec2 way = wayPoint - robot.position;
  safe.wayPointField = wayPoint;
  safe.detour = wayPoint != goal;
  safe.wayPoint = robot.inverse() * wayPoint;
  const double length = way.norm();
  last_ = safe.detour && length > 1e-3 ? Vec2(way / length) : Vec2(Vec2::Zero());
  safe.wait = length > 0.1 && mateGoesBefore(way / length);
}

}  // namespace plumbline
