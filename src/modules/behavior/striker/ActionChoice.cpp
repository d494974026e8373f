#include "modules/behavior/striker/ActionChoice.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "modules/behavior/striker/BallCourse.h"

namespace plumbline {
namespace {

constexpr double mostDeviations = 2.5;  ///< a scatter is integrated so far to either side

/// What one way to play the ball is worth, over directions all round: a row of cells beginning at the goal.
class Fan {
public:
  /// seconds: until the ball is played.
  Fan(const BallCourses& courses, const StrikerSituation& situation, const BallPlay& play, double seconds,
      const ActionChoiceParameters& parameters)
      : count_(parameters.directions), cell_(2 * pi / parameters.directions) {
    const Vec2 toGoal = situation.goal() - situation.ball;
    middle_ = std::atan2(toGoal.y(), toGoal.x());
    const auto angleTo = [&](double y) {
      return normalizeAngle(std::atan2(y - situation.ball.y(), situation.halfLength - situation.ball.x()) -
                            middle_);
    };
    const double inside = situation.goalHalfWidth - situation.ballRadius;
    const double right = angleTo(-inside), left = angleTo(inside);
    reach_ = static_cast<int>(std::ceil(mostDeviations * play.kick.scatter / cell_));
    const double goalWorth = situation.others.empty() ? 1 : parameters.goalWorth;
    widest_ = std::min(static_cast<int>(parameters.widest / cell_), count_ / 2 - reach_ - 1);
    const Receivers receivers = courses.receivers(seconds);
    for (int i = -widest_ - reach_; i <= widest_ + reach_; ++i) {
      const double offset = i * cell_;
      const BallCourse course = courses.course(middle_ + offset, play, receivers);
      // The share of the cell that lies between the posts.
      const double share =
          std::max(0.0, std::min(left, offset + cell_ / 2) - std::max(right, offset - cell_ / 2)) / cell_;
      const double in = share * course.goal;
      const double out = course.over - in;
      cells_.push_back({in * goalWorth + out * course.out + (1 - course.over) * course.rest, in, course.way});
    }
    for (int i = -reach_; i <= reach_; ++i)
      weights_.push_back(std::exp(-0.5 * std::pow(i * cell_ / play.kick.scatter, 2)));
    const double sum = std::accumulate(weights_.begin(), weights_.end(), 0.0);
    for (double& weight : weights_) weight /= sum;
  }

  int widest() const { return widest_; }
  double direction(int i) const { return normalizeAngle(middle_ + i * cell_); }
  /// The nearest cell that may be chosen.
  int cellOf(double direction) const {
    const auto i = static_cast<int>(std::lround(normalizeAngle(direction - middle_) / cell_));
    return std::clamp(i, -widest_, widest_);
  }
  double cell() const { return cell_; }
  double way(int i) const { return at(i).way; }
  /// Mean over the scatter.
  double value(int i) const { return mean(i, &Cell::value); }
  double goal(int i) const { return mean(i, &Cell::goal); }

private:
  struct Cell {
    double value = 0, goal = 0, way = 0;
  };
  const Cell& at(int i) const { return cells_[static_cast<std::size_t>(i + widest_ + reach_)]; }
  double mean(int i, double Cell::*what) const {
    double sum = 0;
    for (int k = -reach_; k <= reach_; ++k)
      sum += weights_[static_cast<std::size_t>(k + reach_)] * (at(i + k).*what);
    return sum;
  }

  int count_, reach_ = 0, widest_ = 0;
  double cell_, middle_ = 0;
  std::vector<Cell> cells_;
  std::vector<double> weights_;
};

/// Judges the directions of one way to play the ball.
class Judge {
public:
  Judge(const BallCourses& courses, const StrikerSituation& situation, const BallPlay& play,
        const TimeToBallParameters& time, const ActionChoiceParameters& parameters)
      : courses_(courses),
        situation_(situation),
        play_(play),
        time_(time),
        parameters_(parameters),
        ahead_(directionToBall(situation)),
        toBall_(timeToBall(situation.robot, false, situation.ball, situation.ball + ahead_, time)),
        fan_(courses, situation, play, toBall_ + playSeconds(), parameters) {}

  const Fan& fan() const { return fan_; }

  StrikerAction action(int i) const {
    const double direction = fan_.direction(i);
    const Vec2 to(std::cos(direction), std::sin(direction));
    const double round = std::acos(std::clamp(ahead_.dot(to), -1.0, 1.0)) / pi;
    const double seconds = toBall_ + round * parameters_.roundSeconds + playSeconds();
    const double first = 1 / (1 + std::exp((seconds - courses_.opponentSeconds()) / parameters_.timeSpread));
    StrikerAction action;
    action.kind = play_.dribbled ? StrikerAction::Kind::dribble : StrikerAction::Kind::kick;
    action.direction = direction;
    action.reach = play_.kick.distance;
    action.goal = fan_.goal(i);
    action.end = situation_.ball + fan_.way(i) * to;
    // Until the robot is at the ball again, if it did not go in.
    const double after =
        (1 - action.goal) * fan_.way(i) / (play_.dribbled ? parameters_.dribbleSpeed : time_.walkSpeed);
    action.value =
        first * fan_.value(i) + (1 - first) * courses_.lost() - courses_.timePrice() * (seconds + after);
    return action;
  }

  /// How far the direction may be off to the nearer side where it matters.
  double tolerance(int i) const {
    const double least = fan_.value(i) - parameters_.slack;
    int steps = 0;
    while (i + steps + 1 <= fan_.widest() && i - steps - 1 >= -fan_.widest() &&
           fan_.value(i + steps + 1) >= least && fan_.value(i - steps - 1) >= least)
      ++steps;
    return steps * fan_.cell();
  }

private:
  static Vec2 directionToBall(const StrikerSituation& situation) {
    const Vec2 way = situation.ball - situation.robot.position;
    return way.norm() > 1e-6 ? Vec2(way.normalized()) : Vec2(Vec2::UnitX());
  }
  /// From when the robot is at the ball, on the right side of it.
  double playSeconds() const { return play_.dribbled ? parameters_.pushSeconds : parameters_.kickSeconds; }

  const BallCourses& courses_;
  const StrikerSituation& situation_;
  BallPlay play_;
  const TimeToBallParameters& time_;
  const ActionChoiceParameters& parameters_;
  Vec2 ahead_;     ///< from the robot to the ball
  double toBall_;  ///< until it is there, without the way round the ball [s]
  Fan fan_;
};

std::vector<BallPlay> playsOf(const StrikerSituation& situation, const ActionChoiceParameters& parameters) {
  std::vector<BallPlay> plays;
  for (const KickEffect& kick : situation.kicks) plays.push_back({kick, false});
  plays.push_back(
      {{.distance = parameters.dribbleWay, .scatter = parameters.dribbleScatter, .spread = 0}, true});
  return plays;
}

bool isOf(const StrikerAction& action, const BallPlay& play) {
  return (action.kind == StrikerAction::Kind::dribble) == play.dribbled &&
         std::abs(action.reach - play.kick.distance) < 1e-9;
}

}  // namespace

StrikerAction judgeAction(StrikerAction::Kind kind, double direction, double reach,
                          const StrikerSituation& situation, const FieldValue& value,
                          const TimeToBallParameters& time, const ActionChoiceParameters& parameters) {
  const BallCourses courses(situation, value, time, parameters);
  StrikerAction asked;
  asked.kind = kind;
  asked.reach = reach;
  for (const BallPlay& play : playsOf(situation, parameters)) {
    if (!isOf(asked, play)) continue;
    const Judge judge(courses, situation, play, time, parameters);
    asked = judge.action(judge.fan().cellOf(direction));
    asked.tolerance = judge.tolerance(judge.fan().cellOf(direction));
    break;
  }
  return asked;
}

StrikerAction chooseAction(const StrikerSituation& situation, const StrikerAction& last,
                           const FieldValue& value, const TimeToBallParameters& time,
                           const ActionChoiceParameters& parameters, std::vector<StrikerAction>* compared) {
  const BallCourses courses(situation, value, time, parameters);
  StrikerAction best, again;
  if (compared) compared->clear();
  for (const BallPlay& play : playsOf(situation, parameters)) {
    const Judge judge(courses, situation, play, time, parameters);
    StrikerAction bestOfPlay;
    int chosen = 0;
    for (int i = -judge.fan().widest(); i <= judge.fan().widest(); ++i) {
      const StrikerAction action = judge.action(i);
      if (bestOfPlay.kind != StrikerAction::Kind::none && action.value <= bestOfPlay.value) continue;
      bestOfPlay = action;
      chosen = i;
    }
    if (compared) compared->push_back(bestOfPlay);
    if (best.kind == StrikerAction::Kind::none || bestOfPlay.value > best.value) {
      best = bestOfPlay;
      best.tolerance = judge.tolerance(chosen);
    }
    if (last.kind == StrikerAction::Kind::none || !isOf(last, play)) continue;
    const int before = judge.fan().cellOf(last.direction);
    again = judge.action(before);
    again.tolerance = judge.tolerance(before);
  }
  if (again.kind == StrikerAction::Kind::none) return best;
  const double near = std::clamp(1 - (situation.ball - situation.robot.position).norm(), 0.0, 1.0);
  const double hysteresis =
      std::lerp(parameters.hysteresis, std::max(parameters.hysteresis, parameters.hysteresisAtBall), near);
  return best.value > again.value + hysteresis ? best : again;
}

}  // namespace plumbline
