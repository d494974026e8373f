#include "motion/Gaze.h"

#include <algorithm>
#include <cmath>

namespace plumbline::motion {

namespace {

constexpr double yawStep = 0.1;  // between the yaws that are tried [rad]
constexpr double landmarkWorth = 1.0;
constexpr double turnCost = 0.4;     // landmarks a turn of 1 rad has to bring
constexpr double offBallCost = 0.8;  // landmarks 1 rad away from the ball has to bring

/// Directions in which the robot sees them, left of its front [rad].
std::vector<double> bearings(const Pose2& robot, const std::vector<Vec2>& landmarks) {
  const Pose2 toRobot = robot.inverse();
  std::vector<double> angles;
  angles.reserve(landmarks.size());
  for (const Vec2& landmark : landmarks) {
    const Vec2 seen = toRobot * landmark;
    angles.push_back(std::atan2(seen.y(), seen.x()));
  }
  return angles;
}

/// Landmarks within the cone for that yaw; those at its edge count less, so that the view is stable.
double landmarksInView(double yaw, const std::vector<double>& bearings, double halfView) {
  double sum = 0;
  for (const double bearing : bearings) {
    const double off = std::abs(normalizeAngle(bearing - yaw));
    sum += std::clamp((halfView - off) / 0.15, 0.0, 1.0);
  }
  return sum;
}

}  // namespace

HeadAngles lookAtBall(const Vec2& ball, const std::optional<Pose2>& robot, const std::vector<Vec2>& landmarks,
                      double current, const GazeParameters& p) {
  HeadAngles head;
  const double distance = ball.norm();
  // The ball a third of the half view below the axis: the near field and the far landmarks are both in view.
  head.pitch = std::clamp(std::atan2(p.cameraHeight, distance) - p.halfView / 3, p.minPitch, p.maxPitch);
  const double bearing = std::atan2(ball.y(), ball.x());
  const double direct = std::clamp(bearing, -p.maxYaw, p.maxYaw);
  head.yaw = direct;
  if (!robot) return head;
  const std::vector<double> seen = bearings(*robot, landmarks);
  double best = -1e9;
  const double freedom = p.halfView - p.ballMargin;
  const double farthest = std::max(freedom, std::abs(bearing - direct));
  const int steps = static_cast<int>(freedom / yawStep);
  for (int i = -steps; i <= steps; ++i) {
    const double yaw = std::clamp(direct + i * yawStep, -p.maxYaw, p.maxYaw);
    if (std::abs(bearing - yaw) > farthest) continue;
    const double worth = landmarkWorth * landmarksInView(yaw, seen, p.halfView) -
                         turnCost * std::abs(yaw - current) - offBallCost * std::abs(yaw - direct);
    if (worth > best) {
      best = worth;
      head.yaw = yaw;
    }
  }
  return head;
}

HeadAngles scan(double seconds, double from, double firstSide, const GazeParameters& p) {
  // A triangle wave; `way` is the path of the head from the far side, as if it never turned back.
  const double start = std::clamp(firstSide * from, -p.scanYaw, p.scanYaw) + p.scanYaw;
  const double way = std::fmod(start + 4 * p.scanYaw * seconds / p.scanSeconds, 4 * p.scanYaw);
  const double wave = way < 2 * p.scanYaw ? way - p.scanYaw : 3 * p.scanYaw - way;
  return {firstSide * wave, 0.1};
}

}  // namespace plumbline::motion
