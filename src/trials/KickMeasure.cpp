#include "trials/KickMeasure.h"

#include <algorithm>
#include <cmath>

#include "field/FieldSize.h"
#include "math/Angle.h"

namespace plumbline {
namespace {

constexpr FieldSize field;
constexpr double shotFrom = 3, shotTo = 8;  // where a goal stands that one shoots at [m]

}  // namespace

KickMeasure::KickMeasure(const KickOptions& options, const Pose2& robot, const Vec2& ball)
    : wish_(options.wish), direction_(fromDegrees(options.direction)), robot_(robot), from_(ball) {}

void KickMeasure::see(const Vec3& ball) {
  highest_ = std::max(highest_, ball.z());
  const double way = (ball.head<2>() - from_).norm();
  if (way < shotFrom || way > shotTo) return;
  came_ = true;
  top_ = std::max(top_, ball.z() + field.ballRadius);
}

TaskOutcome KickMeasure::outcome(const End& end) const {
  motion::KickTry result;
  result.way = Eigen::Rotation2Dd(-robot_.heading - direction_) * (end.ball - from_);
  result.height = highest_ - field.ballRadius;
  result.top = top_;
  result.milliseconds = end.milliseconds;
  result.error = end.error;
  const double off = toDegrees(result.direction());
  TaskOutcome outcome;
  outcome.cost = wish_.cost(result);
  outcome.figures = {{"distance", result.way.x()},
                     {"direction", toDegrees(direction_) + off},
                     {"off", std::abs(off)},
                     {"height", result.height},
                     {"time", end.milliseconds},
                     {"error", end.error},
                     {"up", end.up ? 1.0 : 0.0},
                     {"top", top_},
                     {"low", came_ && top_ < field.goalHeight ? 1.0 : 0.0}};
  return outcome;
}

}  // namespace plumbline
