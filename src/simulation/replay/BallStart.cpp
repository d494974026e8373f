#include "simulation/replay/BallStart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/SolvePositive.h"
#include "simulation/league/MakeWorld.h"

namespace plumbline::simulation {

namespace {

using simspark::LeagueTrace;
using simspark::traceStep;
using Start = Eigen::Matrix<double, 6, 1>;  // position, velocity

constexpr std::size_t manyRows = 10;
constexpr double goodFit = 2e-5;    // root mean square [m]; the files have six digits
constexpr double fastestBall = 25;  // [m/s]

/// The fit of a ball alone on the field to some rows of a trace.
class BallFit {
public:
  BallFit(const LeagueTrace& trace, std::size_t first, std::size_t count, const WorldConfig& config)
      : trace_(trace),
        first_(first),
        count_(count),
        world_(makeWorld(config)),
        ballRadius_(config.field.ballRadius) {}

  /// The best of several descents: on the ground the ball has contact from the first step or it has not,
  /// which a descent cannot change.
  Start solve() {
    const Vec3 position = trace_.rows[first_].ball;
    const Vec3 velocity = (trace_.rows[first_ + 1].ball - position) / traceStep;
    Start best;
    double bestRms = std::numeric_limits<double>::infinity();
    for (const double height : {position.z() - velocity.z() * traceStep, position.z(), ballRadius_ - 1e-9}) {
      Start start;
      start << position - velocity * traceStep, velocity;
      start[2] = height;
      start = descend(start);
      if (const double error = rms(start); error < bestRms) {
        best = start;
        bestRms = error;
      }
    }
    return best;
  }

  double rms(const Start& start) {
    return std::sqrt(errors(start).squaredNorm() / static_cast<double>(count_));
  }

private:
  /// Gauss-Newton.
  Start descend(Start start) {
    for (int iteration = 0; iteration < 8; ++iteration) {
      const Eigen::VectorXd error = errors(start);
      Eigen::MatrixXd slope(error.size(), 6);
      constexpr double small = 1e-7;
      for (int i = 0; i < 6; ++i) {
        Start moved = start;
        moved[i] -= small;
        slope.col(i) = (error - errors(moved)) / small;
      }
      Eigen::Matrix<double, 6, 6> normal = slope.transpose() * slope;
      normal.diagonal().array() += 1e-12;
      Start step = slope.transpose() * error;
      if (solvePositive(normal, step)) start -= step;
    }
    return start;
  }

  Eigen::VectorXd errors(const Start& start) {
    Eigen::VectorXd result(3 * count_);
    world_->setBall(start.head<3>(), start.tail<3>());
    for (std::size_t i = 0; i < count_; ++i) {
      world_->step();
      result.segment<3>(static_cast<Eigen::Index>(3 * i)) =
          world_->ball().pose.translation() - trace_.rows[first_ + i].ball;
    }
    return result;
  }

  const LeagueTrace& trace_;
  std::size_t first_, count_;
  std::unique_ptr<World> world_;
  double ballRadius_;
};

}  // namespace

bool ballJumps(const LeagueTrace& trace, std::size_t row) {
  return row > 0 && (trace.rows[row].ball - trace.rows[row - 1].ball).norm() > fastestBall * traceStep;
}

BodyState ballBefore(const LeagueTrace& trace, std::size_t row, const WorldConfig& config) {
  std::size_t count = std::min(manyRows, trace.rows.size() - row);
  for (std::size_t i = 1; i < count; ++i)
    if (ballJumps(trace, row + i)) count = i;
  BodyState before;
  before.pose = translation(trace.rows[row].ball);
  if (count < 2) return before;
  BallFit fit(trace, row, count, config);
  Start start = fit.solve();
  if (fit.rms(start) > goodFit) start = BallFit(trace, row, 2, config).solve();
  before.pose = translation(Vec3(start.head<3>()));
  before.linearVelocity = start.tail<3>();
  return before;
}

BodyState ballAfterOneStep(const BodyState& before, const WorldConfig& config) {
  const auto world = makeWorld(config);
  world->setBall(before);
  world->step();
  return world->ball();
}

}  // namespace plumbline::simulation
