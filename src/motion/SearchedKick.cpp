#include "motion/SearchedKick.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumbline::motion {
namespace {

constexpr double distanceWorth = 30, heightWorth = 120;  // formula 3.2
constexpr double tooHigh = 60, tooHighByMetres = 300;    // two metres of distance, and ten a metre
constexpr double placeSigma = 5;                         // [mm]
constexpr double hardlyMoved = 0.1;                      // [m]

KeyframeMotion plain(KeyframeMotion kick, Side foot) {
  if (kick.ball == Vec2::Zero()) throw std::invalid_argument(kick.name + " is no kick: it has no ball");
  if ((kick.ball.y() > 0) != (foot == Side::left)) kick = mirrored(kick);
  kick.ballReach = Vec2::Zero();
  kick.kick.reset();
  for (Keyframe& frame : kick.keyframes) frame.ballGains.clear();
  return kick;
}

}  // namespace

SearchedKick::SearchedKick(const KeyframeMotion& kick, const RobotModel& robot, Side foot)
    : first_(plain(kick, foot)), motion_(first_, robot, Sides::apart), list_(motion_.list()) {
  const Vec2 place = 1e3 * first_.ball;
  const bool left = foot == Side::left;
  list_.push_back({"ballX", place.x(), 100, 300, placeSigma});
  list_.push_back({"ballY", place.y(), left ? -20.0 : -150.0, left ? 150.0 : 20.0, placeSigma});
}

KeyframeMotion SearchedKick::written(const Eigen::VectorXd& values, double cycle) const {
  const Eigen::Index n = values.size() - 2;
  KeyframeMotion kick = motion_.written(values.head(n), cycle);
  kick.ball = Vec2(std::round(values[n]) / 1e3, std::round(values[n + 1]) / 1e3);
  return kick;
}

double KickTry::direction() const { return way.norm() > hardlyMoved ? std::atan2(way.y(), way.x()) : 0; }

double KickWish::cost(const KickTry& kick) const {
  double rest = distanceWorth * std::abs(kick.way.y()) + steady * kick.error + weight * kick.milliseconds;
  if (ceiling > 0 && kick.top > ceiling) rest += tooHigh + tooHighByMetres * (kick.top - ceiling);
  if (distance > 0) return rest + distanceWorth * std::abs(kick.way.x() - distance);
  const double worthOfHeight = ceiling > 0 ? 0 : heightWorth;
  return rest - distanceWorth * kick.way.x() - worthOfHeight * std::min(1.0, kick.height);
}

}  // namespace plumbline::motion
