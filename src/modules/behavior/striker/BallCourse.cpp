#include "modules/behavior/striker/BallCourse.h"

#include <algorithm>
#include <cmath>

#include "math/NormalDistribution.h"
#include "modules/behavior/striker/KickFlight.h"
#include "tactics/RollingBall.h"

namespace plumbline {
namespace {

constexpr double farAway = 1e3;       ///< [m], [s]
constexpr double narrowSeconds = 10;  ///< that a goal seen from its line costs more
constexpr double wideOpening = 0.3;   ///< angle between the posts from which on it costs nothing [rad]
constexpr double longestStep = 2;     ///< for which an opponent comes nearer to the ball's way [s]
constexpr double shortest = 0.05;     ///< way of a ball [m]
constexpr double overLying = 0.2;     ///< a kick that rises so high goes over a robot that lies [m]
constexpr double comesToBall = 0.85;  ///< cosine between its velocity and the way to the ball

/// When a ball that goes `reach` in all has gone `way` [s].
double rollingSeconds(double way, double reach) {
  return way >= reach ? farAway : -ballRollingSeconds * std::log(1 - way / reach);
}

double firstOf(const std::vector<MovingRobot>& robots, const Vec2& place, const MovingSpeeds& speeds) {
  double first = farAway;
  for (const MovingRobot& robot : robots) {
    const double within = first * speeds.walk;  // from farther away it would be later
    if ((robot.position - place).squaredNorm() < within * within)
      first = std::min(first, secondsTo(robot, place, speeds));
  }
  return first;
}

}  // namespace

BallCourses::BallCourses(const StrikerSituation& situation, const FieldValue& value,
                         const TimeToBallParameters& time, const ActionChoiceParameters& parameters)
    : situation_(situation), value_(value), time_(time), parameters_(parameters) {
  if (situation.others.empty()) timeToGoal_.emplace(situation, time, parameters);
  opponentSeconds_ = opponentAtBall();
  lost_ = worth(situation.ball, -1);
}

double BallCourses::worth(const Vec2& place, double advantage) const {
  if (!timeToGoal_) return value_.at({place, advantage});
  const double ahead = std::max(situation_.halfLength - place.x(), 0.05), y = std::abs(place.y());
  const double opening =
      std::atan((y + situation_.goalHalfWidth) / ahead) - std::atan((y - situation_.goalHalfWidth) / ahead);
  const double aside = narrowSeconds * std::max(0.0, 1 - opening / wideOpening);
  return 1 - (timeToGoal_->seconds((situation_.goal() - place).norm()) + aside) / aloneSeconds;
}

double BallCourses::worthOfOut(const Vec2& end, bool overTheirLine) const {
  if (timeToGoal_) return worth(end, 0) - TimeToGoal::restartSeconds / aloneSeconds;
  const double x = overTheirLine ? situation_.halfLength - parameters_.goalKickWay : end.x();
  return value_.at({Vec2(x, overTheirLine ? 0.5 * end.y() : end.y()), -1});
}

Receivers BallCourses::receivers(double seconds) const {
  const MovingSpeeds ours{time_.walkSpeed, time_.turnSpeed};
  const MovingSpeeds theirs{situation_.opponentSpeed, time_.turnSpeed};
  Receivers receivers;
  for (const OtherRobot& robot : situation_.others) {
    MovingRobot moving{.position = robot.position, .velocity = robot.velocity};
    if (robot.fallen) moving.getUpSeconds = time_.getUp;
    if (robot.mate) {
      if (const PlacedPlayer* player = situation_.places.of(robot.number)) {
        moving.heading = player->heading;
        if (player->placed) moving.place = player->place;
      }
      receivers.mates.push_back(movedOn(moving, seconds, ours));
      continue;
    }
    const Vec2 toBall = situation_.ball - robot.position;
    if (robot.velocity.dot(toBall) > comesToBall * robot.velocity.norm() * toBall.norm())
      moving.place = Pose2(situation_.ball, std::atan2(toBall.y(), toBall.x()));
    receivers.opponents.push_back(movedOn(moving, seconds, theirs));
  }
  return receivers;
}

double BallCourses::opponentAtBall() const {
  const Vec2 ownGoal(-situation_.halfLength, 0);
  TimeToBallParameters theirs = time_;
  theirs.walkSpeed = situation_.opponentSpeed;
  double first = farAway;
  for (const OtherRobot& robot : situation_.others) {
    if (robot.mate) continue;
    const Vec2 way = situation_.ball - robot.position;
    // It faces the ball. From the side of its own goal it plays the ball at once; else it goes round it, or
    // pushes it aside: half of either.
    const Pose2 facing(robot.position, std::atan2(way.y(), way.x()));
    const double round = timeToBall(facing, robot.fallen, situation_.ball, ownGoal, theirs);
    const double straight = way.norm() / theirs.walkSpeed + (robot.fallen ? theirs.getUp : 0);
    first = std::min(first, (round + straight) / 2);
  }
  return std::max(first, situation_.freeSeconds);
}

double BallCourses::freeWay(const Vec2& direction, double reach, bool high) const {
  double way = reach;
  for (const OtherRobot& robot : situation_.others) {
    if (robot.fallen && high) continue;
    const Vec2 to = robot.position - situation_.ball;
    const double along = to.dot(direction);
    if (along <= 0 || along >= way) continue;
    const double aside = std::abs(to.x() * direction.y() - to.y() * direction.x());
    const double most =
        robot.mate || robot.fallen ? 0 : parameters_.blockSpeed;  // a step aside, for each second
    if (aside > parameters_.blockWidth + most * longestStep) continue;
    if (aside < parameters_.blockWidth + most * std::min(rollingSeconds(along, reach), longestStep))
      way = along;
  }
  return way;
}

BallCourse BallCourses::course(double direction, const BallPlay& play, const Receivers& receivers) const {
  const Vec2 to(std::cos(direction), std::sin(direction));
  const double toX = std::abs(to.x()) < 1e-9
                         ? farAway
                         : (std::copysign(situation_.halfLength, to.x()) - situation_.ball.x()) / to.x();
  const double toY = std::abs(to.y()) < 1e-9
                         ? farAway
                         : (std::copysign(situation_.halfWidth, to.y()) - situation_.ball.y()) / to.y();
  const double line = std::max(0.0, std::min(toX, toY));
  const double reach = std::max(play.kick.distance, shortest);
  double clear = freeWay(to, reach + 2 * play.kick.spread, play.kick.rise > overLying);
  if (play.dribbled && clear < reach) clear += parameters_.pushThrough * (reach - clear);
  BallCourse course;
  // What is not over the line rests before it, or at a robot.
  course.over = line <= clear ? shareBelow((reach - line) / std::max(play.kick.spread, 1e-3)) : 0.0;
  course.way = std::min({clear, line, reach});
  const Vec2 end = situation_.ball + course.way * to;
  if (course.over > 0) {
    const Vec2 out = situation_.ball + line * to;
    const bool theirs = to.x() > 0 && toX <= toY;
    course.out = worthOfOut(out, theirs);
    if (theirs)
      course.goal = course.over * shareUnderBar(situation_, line / (flyingShare * reach), play.kick.rise);
  }
  if (course.over < 1) {
    double own = play.dribbled ? 0.0 : course.way / time_.walkSpeed;
    own = std::min(own, firstOf(receivers.mates, end, {time_.walkSpeed, time_.turnSpeed}));
    const double theirs = firstOf(receivers.opponents, end, {situation_.opponentSpeed, time_.turnSpeed});
    const double advantage = ballAdvantage(own, theirs);
    course.rest = worth(end, advantage);
  }
  return course;
}

}  // namespace plumbline
