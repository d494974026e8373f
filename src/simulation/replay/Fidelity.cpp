#include "simulation/replay/Fidelity.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "math/Angle.h"
#include "simulation/replay/BallStart.h"

namespace plumbline::simulation {

namespace {

using simspark::TraceRow;
using simspark::traceStep;
using Rows = std::vector<TraceRow>;

constexpr std::size_t rowsIn2s = 100, rowsIn5s = 250;
constexpr double never = std::numeric_limits<double>::quiet_NaN();

double height(const TraceRow& row) { return row.torso.translation().z(); }
double upward(const TraceRow& row) { return row.torso.linear()(2, 2); }

double heading(const TraceRow& row) { return std::atan2(row.torso.linear()(1, 0), row.torso.linear()(0, 0)); }

double rotationBetween(const Pose3& a, const Pose3& b) {
  const Mat3 difference = a.linear().transpose() * b.linear();
  return Eigen::AngleAxisd(difference).angle();
}

/// Time of the first row that leans by this angle [s], or never.
double leansAt(const Rows& rows, double angle) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (upward(rows[i]) < std::cos(angle)) return static_cast<double>(i) * traceStep;
  return never;
}

double turned(const Rows& rows, std::size_t from) {
  double sum = 0;
  for (std::size_t i = from + 1; i < rows.size(); ++i)
    sum += normalizeAngle(heading(rows[i]) - heading(rows[i - 1]));
  return sum;
}

std::size_t lastFiveSeconds(const Rows& rows) {
  return rows.size() > rowsIn5s ? rows.size() - 1 - rowsIn5s : 0;
}

double walkingSpeed(const Rows& rows) {
  const std::size_t from = lastFiveSeconds(rows);
  const Vec3 way = rows.back().torso.translation() - rows[from].torso.translation();
  return way.head<2>().norm() / (static_cast<double>(rows.size() - 1 - from) * traceStep);
}

/// Amplitude of the torso's swinging to the side of its way over the last 5 s, without a quadratic trend.
double sway(const Rows& rows) {
  const std::size_t from = lastFiveSeconds(rows), count = rows.size() - from;
  const Vec2 way = (rows.back().torso.translation() - rows[from].torso.translation()).head<2>().normalized();
  Eigen::MatrixX3d trend(static_cast<Eigen::Index>(count), 3);
  Eigen::VectorXd side(static_cast<Eigen::Index>(count));
  for (Eigen::Index i = 0; i < side.size(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count);
    const Vec3 p = rows[from + static_cast<std::size_t>(i)].torso.translation();
    trend.row(i) << 1, t, t * t;
    side[i] = -way.y() * p.x() + way.x() * p.y();
  }
  const Mat3 normal = trend.transpose() * trend;
  const Eigen::VectorXd rest = side - trend * (normal.inverse() * (trend.transpose() * side));
  return std::sqrt(2 * rest.squaredNorm() / static_cast<double>(count));
}

struct BallFigures {
  double distance = 0, fastest = 0, apex = 0;
};

/// Since the ball was last set.
BallFigures ballFigures(const Rows& rows, std::size_t from) {
  BallFigures result;
  result.distance = (rows.back().ball - rows[from].ball).head<2>().norm();
  for (std::size_t i = from; i < rows.size(); ++i) result.apex = std::max(result.apex, rows[i].ball.z());
  for (std::size_t i = from + 1; i < rows.size(); ++i)
    result.fastest = std::max(result.fastest, (rows[i].ball - rows[i - 1].ball).norm() / traceStep);
  return result;
}

double footForce(const TraceRow& row) {
  double sum = 0;
  for (const auto* force : {&row.leftFootForce, &row.rightFootForce, &row.leftToeForce, &row.rightToeForce})
    if (*force) sum += (*force)->force.z();
  return sum;
}

}  // namespace

std::vector<TraceFigure> figures(const Rows& league, const Rows& ours) {
  std::vector<TraceFigure> result;
  const auto add = [&](const char* name, const char* unit, auto&& figure) {
    result.push_back({name, unit, figure(league), figure(ours)});
  };
  const auto lowest = [](const Rows& rows) {
    return height(*std::min_element(rows.begin(), rows.end(), [](const TraceRow& a, const TraceRow& b) {
      return height(a) < height(b);
    }));
  };
  const auto kneeMost = [](const Rows& rows) {
    double most = 0;
    for (const TraceRow& row : rows) most = std::max(most, row.angle[lKneePitch]);
    return toDegrees(most);
  };
  add("torso height, lowest", "m", lowest);
  add("torso height, last", "m", [](const Rows& rows) { return height(rows.back()); });
  add("torso up-axis z, last", "", [](const Rows& rows) { return upward(rows.back()); });
  add("knee, most bent", "deg", kneeMost);
  if (leansAt(league, fromDegrees(45)) >= 0) {
    add("leans by 45 deg at", "s", [](const Rows& rows) { return leansAt(rows, fromDegrees(45)); });
    add("leans by 60 deg at", "s", [](const Rows& rows) { return leansAt(rows, fromDegrees(60)); });
  }
  if (walkingSpeed(league) > 0.1) {
    add("speed, last 5 s", "m/s", walkingSpeed);
    add("sway, last 5 s", "mm", [](const Rows& rows) { return 1000 * sway(rows); });
  }
  if (std::abs(turned(league, 0)) > fromDegrees(1)) {
    add("turned", "deg", [](const Rows& rows) { return toDegrees(turned(rows, 0)); });
    add("turn rate, last 5 s", "deg/s", [](const Rows& rows) {
      const std::size_t from = lastFiveSeconds(rows);
      return toDegrees(turned(rows, from)) / (static_cast<double>(rows.size() - 1 - from) * traceStep);
    });
  }
  simspark::LeagueTrace whole;
  whole.rows = league;
  std::size_t from = 0;
  for (std::size_t i = 1; i < league.size(); ++i)
    if (ballJumps(whole, i)) from = i;
  if (ballFigures(league, from).fastest > 0.05) {
    add("ball, distance", "m", [&](const Rows& rows) { return ballFigures(rows, from).distance; });
    add("ball, fastest", "m/s", [&](const Rows& rows) { return ballFigures(rows, from).fastest; });
    add("ball, highest", "m", [&](const Rows& rows) { return ballFigures(rows, from).apex; });
  }
  return result;
}

TraceDeviation deviation(const Rows& league, const Rows& ours) {
  if (league.size() != ours.size() || league.empty())
    throw std::invalid_argument("replay: rows to compare must be as many");
  TraceDeviation result;
  double gyro = 0, acc = 0, force = 0;
  for (std::size_t i = 0; i < league.size(); ++i) {
    const TraceRow &a = league[i], &b = ours[i];
    const double position = (a.torso.translation() - b.torso.translation()).norm();
    const double rotation = rotationBetween(a.torso, b.torso);
    const double turn = std::abs(normalizeAngle(heading(a) - heading(b)));
    double angle = 0;
    for (std::size_t j = 0; j < maxJoints; ++j) angle = std::max(angle, std::abs(a.angle[j] - b.angle[j]));
    const auto raise = [&](double& whole, double& first2s, double value) {
      whole = std::max(whole, value);
      if (i <= rowsIn2s) first2s = whole;
    };
    raise(result.position, result.position2s, position);
    raise(result.rotation, result.rotation2s, rotation);
    raise(result.heading, result.heading2s, turn);
    raise(result.angle, result.angle2s, angle);
    result.ball = std::max(result.ball, (a.ball - b.ball).head<2>().norm());
    result.positionAtEnd = position;
    if (result.rowOff1mm < 0 && position > 1e-3) result.rowOff1mm = static_cast<int>(i);
    if (result.rowOff1cm < 0 && position > 1e-2) result.rowOff1cm = static_cast<int>(i);
    if (i < 2) continue;
    gyro += (a.gyro - b.gyro).squaredNorm();
    acc += (a.acc - b.acc).squaredNorm();
    force += std::pow(footForce(a) - footForce(b), 2);
  }
  const double compared = static_cast<double>(std::max<std::size_t>(league.size(), 3) - 2);
  result.gyroRms = std::sqrt(gyro / compared);
  result.accRms = std::sqrt(acc / compared);
  result.footForceRms = std::sqrt(force / compared);
  return result;
}

std::string fidelityReport(const simspark::LeagueTrace& trace, const Rows& ours, int robotType) {
  std::string text;
  char line[160];
  const auto print = [&](const char* format, auto... values) {
    std::snprintf(line, sizeof line, format, values...);
    text += line;
  };
  text += trace.name + ", robot type " + std::to_string(robotType) + ", " + std::to_string(ours.size()) +
          " rows\n";
  print("%-28s %12s %12s %12s  %s\n", "", "league", "ours", "difference", "unit");
  for (const TraceFigure& figure : figures(trace.rows, ours))
    print("%-28s %12.5f %12.5f %12.5f  %s\n", figure.name.c_str(), figure.league, figure.ours,
          figure.ours - figure.league, figure.unit.c_str());
  const TraceDeviation d = deviation(trace.rows, ours);
  print("%-28s %12s %12s %12s  %s\n", "largest deviation", "first 2 s", "all", "at the end", "unit");
  print("%-28s %12.4f %12.4f %12.4f  mm\n", "torso position", 1000 * d.position2s, 1000 * d.position,
        1000 * d.positionAtEnd);
  print("%-28s %12.4f %12.4f %12s  deg\n", "torso rotation", toDegrees(d.rotation2s), toDegrees(d.rotation),
        "");
  print("%-28s %12.4f %12.4f %12s  deg\n", "heading", toDegrees(d.heading2s), toDegrees(d.heading), "");
  print("%-28s %12.4f %12.4f %12s  deg\n", "worst joint", toDegrees(d.angle2s), toDegrees(d.angle), "");
  print("%-28s %12s %12.4f %12s  mm\n", "ball, horizontally", "", 1000 * d.ball, "");
  print("root mean square: gyro %.4f deg/s, accelerometer %.4f m/s^2, feet %.4f N\n", toDegrees(d.gyroRms),
        d.accRms, d.footForceRms);
  print("torso off by 1 mm from row %d, by 1 cm from row %d (-1: never)\n", d.rowOff1mm, d.rowOff1cm);
  return text;
}

}  // namespace plumbline::simulation
