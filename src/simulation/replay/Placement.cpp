#include "simulation/replay/Placement.h"

#include "math/Gravity.h"

namespace plumbline::simulation {

namespace {

using simspark::LeagueTrace;
using simspark::TraceRow;
using simspark::traceStep;

// The sensors' rounding moves the torso by a micrometre in a step; falling asleep stops up to 0.01 m/s.
constexpr double sameWay = 1e-3;       // [m]
constexpr double sameTurn = 1e-3;      // [rad]
constexpr double farthestAStep = 0.5;  // [m]; faster than any robot moves
constexpr double sameSpeed = 2e-3;     // [m/s]; six digits of two places

Mat3 turnInStep(const TraceRow& row) {
  const double angle = row.gyro.norm() * traceStep;
  if (angle == 0) return Mat3::Identity();
  return Eigen::AngleAxisd(angle, row.gyro.normalized()).toRotationMatrix();
}

}  // namespace

Vec3 addedVelocity(const LeagueTrace& trace, std::size_t row) {
  return traceStep * (trace.rows[row].torso.linear() * trace.rows[row + 1].acc - Vec3(0, 0, earthGravity));
}

bool isPlaced(const LeagueTrace& trace, std::size_t row) {
  if (row < 2 || row >= trace.rows.size()) return false;
  const TraceRow &now = trace.rows[row], &before = trace.rows[row - 1], &earlier = trace.rows[row - 2];
  const Vec3 way = now.torso.translation() - before.torso.translation();
  if (row + 1 == trace.rows.size()) return way.norm() > farthestAStep;
  const Mat3 turn = before.torso.linear().transpose() * now.torso.linear() * turnInStep(now).transpose();
  if (Eigen::AngleAxisd(turn).angle() > sameTurn) return true;
  const Vec3 velocity = (before.torso.translation() - earlier.torso.translation()) / traceStep;
  const Vec3 added = addedVelocity(trace, row);
  const auto comesFrom = [&](const Vec3& v) { return (way - traceStep * (v + added)).norm() < sameWay; };
  if (comesFrom(velocity)) return false;
  // If the robot is placed in the next step, the accelerometer shows there already how it lost its speed.
  const TraceRow& next = trace.rows[row + 1];
  const Vec3 lost = traceStep * (next.torso.linear() * next.acc - Vec3(0, 0, earthGravity));
  if (velocity.norm() > sameSpeed && (velocity + lost).norm() < sameSpeed) return false;
  // Right after a placement the rows before show no velocity; it began at rest.
  return !isPlaced(trace, row - 1) || !comesFrom(addedVelocity(trace, row - 1));
}

Pose3 placeBefore(const LeagueTrace& trace, std::size_t row) {
  const TraceRow& now = trace.rows[row];
  Pose3 place = now.torso;
  if (row + 1 == trace.rows.size()) return place;
  place.translation() -= traceStep * addedVelocity(trace, row);
  place.linear() = now.torso.linear() * turnInStep(now).transpose();
  return place;
}

}  // namespace plumbline::simulation
