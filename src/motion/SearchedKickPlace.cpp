#include "motion/SearchedKickPlace.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "math/Angle.h"

namespace plumbline::motion {
namespace {

constexpr double reach = 40, ballSigma = 8;      // around the present place [mm]
constexpr double turn = 20, directionSigma = 2;  // around the present direction [deg]

}  // namespace

SearchedKickPlace::SearchedKickPlace(KeyframeMotion kick) : first_(std::move(kick)) {
  if (!first_.kick) throw std::invalid_argument(first_.name + " is no kick: it has no key kick");
  const double x = 1e3 * first_.ball.x(), y = 1e3 * first_.ball.y();
  const double direction = toDegrees(first_.kick->direction);
  list_ = {{"ballX", x, x - reach, x + reach, ballSigma},
           {"ballY", y, y - reach, y + reach, ballSigma},
           {"direction", direction, direction - turn, direction + turn, directionSigma}};
}

KeyframeMotion SearchedKickPlace::written(const Eigen::VectorXd& values) const {
  KeyframeMotion kick = first_;
  kick.ball = Vec2(std::round(values[0]) / 1e3, std::round(values[1]) / 1e3);
  kick.kick->direction = fromDegrees(std::round(100 * values[2]) / 100);
  return kick;
}

}  // namespace plumbline::motion
