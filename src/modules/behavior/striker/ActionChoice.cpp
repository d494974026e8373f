#include "modules/behavior/striker/ActionChoice.h"

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

constexpr double farAway = 1e3;  ///< [m]

double arrival(const OtherRobot& robot, const Vec2& place, const TimeToBallParameters& time) {
  return (robot.position - place).norm() / time.walkSpeed + (robot.fallen ? time.getUp : 0);
}

/// How long the first of a team needs to a place, without the robot itself [s].
double firstArrival(const StrikerSituation& situation, bool mates, const Vec2& place,
                    const TimeToBallParameters& time) {
  double first = farAway;
  for (const OtherRobot& robot : situation.others)
    if (robot.mate == mates) first = std::min(first, arrival(robot, place, time));
  return first;
}

/// How far the ball gets before a robot that stands in its way [m].
double freeWay(const StrikerSituation& situation, const Vec2& direction, double way, double width) {
  for (const OtherRobot& robot : situation.others) {
    if (robot.fallen) continue;
    const Vec2 to = robot.position - situation.ball;
    const double along = to.dot(direction);
    if (along > 0 && along < way && std::abs(to.x() * direction.y() - to.y() * direction.x()) < width)
      way = along;
  }
  return way;
}

/// The probability that a ball which is played in a direction goes between the posts, if it rolls so far.
double goalShare(const StrikerSituation& situation, double direction, double scatter) {
  const auto angleTo = [&](double y) {
    return std::atan2(y - situation.ball.y(), situation.halfLength - situation.ball.x());
  };
  const auto below = [&](double angle) {
    return 0.5 * std::erfc(normalizeAngle(direction - angle) / scatter / std::sqrt(2.0));
  };
  return std::max(0.0, below(angleTo(situation.goalHalfWidth)) - below(angleTo(-situation.goalHalfWidth)));
}

/// Where the ball leaves the field on its way, and how far that is; beyond `way`: it stays in.
double wayToLine(const StrikerSituation& situation, const Vec2& direction) {
  double way = farAway;
  if (std::abs(direction.x()) > 1e-9)
    way = std::min(way,
                   (std::copysign(situation.halfLength, direction.x()) - situation.ball.x()) / direction.x());
  if (std::abs(direction.y()) > 1e-9)
    way = std::min(way,
                   (std::copysign(situation.halfWidth, direction.y()) - situation.ball.y()) / direction.y());
  return std::max(0.0, way);
}

/// The way of a ball that goes in a direction, and what its end is worth if that is no goal.
struct Course {
  double way = 0;  ///< [m]
  double value = 0;
  bool toGoalLine = false;  ///< it crosses the opponents' line
};

Course courseOf(double direction, double reach, bool kicked, const StrikerSituation& situation,
                const FieldValue& value, const TimeToBallParameters& time, double blockWidth) {
  const Vec2 way(std::cos(direction), std::sin(direction));
  const double clear = freeWay(situation, way, reach, blockWidth), line = wayToLine(situation, way);
  Course course{std::min(clear, line), 0, false};
  const Vec2 end = situation.ball + course.way * way;
  if (line <= clear) {
    course.toGoalLine = way.x() > 0 && std::abs(end.x() - situation.halfLength) < 1e-6;
    course.value = value.at({end, -1});
    return course;
  }
  // The robot itself runs after its kick; a dribbled ball it takes along.
  const double own = kicked ? clear / time.walkSpeed : 0.0;
  const double ours = std::min(own, firstArrival(situation, true, end, time));
  course.value = value.at({end, ballAdvantage(ours, firstArrival(situation, false, end, time))});
  return course;
}

}  // namespace

StrikerAction judgeAction(StrikerAction::Kind kind, double direction, double reach,
                          const StrikerSituation& situation, const FieldValue& value,
                          const TimeToBallParameters& time, const ActionChoiceParameters& parameters) {
  const bool kicks = kind == StrikerAction::Kind::kick;
  const Vec2 way(std::cos(direction), std::sin(direction));
  double seconds = timeToBall(situation.robot, false, situation.ball, situation.ball + way, time);
  if (kicks) seconds += parameters.kickSeconds;

  const auto course = [&](double angle) {
    return courseOf(angle, reach, kicks, situation, value, time, parameters.blockWidth);
  };
  const Course middle = course(direction);
  if (!kicks) seconds += middle.way / parameters.dribbleSpeed / 2;  // it can be lost half-way
  StrikerAction action{kind, direction, reach, 0, situation.ball + middle.way * way};
  // The mean over directions that are normally distributed (Gauss and Hermite's rule of three points).
  const double scatter = kicks ? parameters.kickScatter : parameters.kickScatter / 2;
  const double aside = std::sqrt(3.0) * scatter;
  const double elsewhere =
      (4 * middle.value + course(direction + aside).value + course(direction - aside).value) / 6;
  const double in = middle.toGoalLine ? goalShare(situation, direction, scatter) : 0;
  const double outcome = in + (1 - in) * elsewhere;
  const double opponent = firstArrival(situation, false, situation.ball, time);
  const double first = 1 / (1 + std::exp((seconds - opponent) / parameters.timeSpread));
  action.value = first * outcome + (1 - first) * value.at({situation.ball, -1});
  return action;
}

StrikerAction chooseAction(const StrikerSituation& situation, const StrikerAction& last,
                           const FieldValue& value, const TimeToBallParameters& time,
                           const ActionChoiceParameters& parameters) {
  const auto judge = [&](StrikerAction::Kind kind, double direction, double reach) {
    return judgeAction(kind, direction, reach, situation, value, time, parameters);
  };
  const Vec2 toGoal = situation.goal() - situation.ball;
  const double middle = std::atan2(toGoal.y(), toGoal.x());
  StrikerAction best;
  const auto compare = [&](StrikerAction::Kind kind, double reach) {
    for (int i = 0; i < parameters.directions; ++i) {
      const double off = parameters.widest * (2.0 * i / (parameters.directions - 1) - 1);
      const StrikerAction action = judge(kind, normalizeAngle(middle + off), reach);
      if (best.kind == StrikerAction::Kind::none || action.value > best.value) best = action;
    }
  };
  for (const double reach : situation.kicks) compare(StrikerAction::Kind::kick, reach);
  compare(StrikerAction::Kind::dribble, parameters.dribbleWay);
  if (last.kind == StrikerAction::Kind::none) return best;
  const StrikerAction again = judge(last.kind, last.direction, last.reach);
  return best.value > again.value + parameters.stays ? best : again;
}

}  // namespace plumbline
