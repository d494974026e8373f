#include "simulation/replay/StartFit.h"

#include <algorithm>
#include <cmath>

#include "math/SolvePositive.h"
#include "simulation/replay/ReplayedRobots.h"

namespace plumbline::simulation {

namespace {

using simspark::LeagueTrace;
using simspark::TraceRow;
using simspark::traceStep;
using Change = Eigen::Matrix<double, 12, 1>;  // of place, turn, velocity, angular velocity

constexpr std::size_t rowsToFit = 10;
constexpr int iterations = 3;
constexpr double turnDigit = 1e-6;  // of a rotation's entries, and of places below 1 m

/// Step of the differences, and the possible error of the rows [m, rad, m/s, rad/s].
constexpr double small[4] = {1e-6, 1e-6, 1e-5, 1e-5};
constexpr double doubt[4] = {1e-5, 2e-6, 1e-3, 1e-3};

StartState changed(StartState start, const Change& by) {
  start.torso.pose.translation() += by.head<3>();
  const Vec3 turn = by.segment<3>(3);
  if (turn.norm() > 0)
    start.torso.pose.linear() =
        Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * start.torso.pose.linear();
  start.torso.linearVelocity += by.segment<3>(6);
  start.torso.angularVelocity += by.segment<3>(9);
  return start;
}

/// One unit of the last of six digits [m].
double digit(double value) {
  return std::abs(value) < 1 ? turnDigit : std::pow(10, std::floor(std::log10(std::abs(value))) - 5);
}

/// Difference between the torsos of two rows, in digits of the recording.
Eigen::Matrix<double, 6, 1> difference(const TraceRow& league, const TraceRow& ours) {
  Eigen::Matrix<double, 6, 1> result;
  for (int i = 0; i < 3; ++i) {
    const double place = league.torso.translation()[i];
    result[i] = (ours.torso.translation()[i] - place) / digit(place);
  }
  const Eigen::AngleAxisd turn(ours.torso.linear() * league.torso.linear().transpose());
  result.tail<3>() = turn.angle() * turn.axis() / turnDigit;
  return result;
}

class StartFit {
public:
  StartFit(const std::vector<LeagueTrace>& traces, const std::vector<RobotModel>& models,
           const BodyState& ball, const WorldConfig& config)
      : traces_(traces), models_(models), ball_(ball), config_(config) {
    for (std::size_t r = 0; r < traces_.size(); ++r) guesses_.push_back(startState(traces_[r], models_[r]));
    rows_ = std::min(rowsToFit, traces_[0].rows.size());
  }

  std::vector<StartState> solve() {
    std::vector<Change> best(traces_.size(), Change::Zero());
    std::vector<Eigen::VectorXd> error = errors(best);
    for (int iteration = 0; iteration < iterations; ++iteration) {
      const std::vector<Change> next = descend(best, error);
      const std::vector<Eigen::VectorXd> then = errors(next);
      for (std::size_t r = 0; r < traces_.size(); ++r) {
        if (then[r].squaredNorm() >= error[r].squaredNorm()) continue;
        best[r] = next[r];
        error[r] = then[r];
      }
    }
    return starts(best);
  }

private:
  /// A Gauss-Newton step of each robot; all are changed at once, as hardly any touches another one.
  std::vector<Change> descend(const std::vector<Change>& from, const std::vector<Eigen::VectorXd>& error) {
    std::vector<Eigen::MatrixXd> slope(traces_.size(), Eigen::MatrixXd(error[0].size(), 12));
    for (int k = 0; k < 12; ++k) {
      std::vector<Change> moved = from;
      for (Change& change : moved) change[k] += small[k / 3];
      const std::vector<Eigen::VectorXd> there = errors(moved);
      for (std::size_t r = 0; r < traces_.size(); ++r) slope[r].col(k) = (there[r] - error[r]) / small[k / 3];
    }
    std::vector<Change> next = from;
    for (std::size_t r = 0; r < traces_.size(); ++r) {
      Eigen::Matrix<double, 12, 12> normal = slope[r].transpose() * slope[r];
      normal.diagonal().array() += 1e-12;  // what the trace does not show stays
      Change step = slope[r].transpose() * error[r];
      if (solvePositive(normal, step)) next[r] -= step;
    }
    return next;
  }

  std::vector<StartState> starts(const std::vector<Change>& changes) const {
    std::vector<StartState> result;
    for (std::size_t r = 0; r < traces_.size(); ++r) result.push_back(changed(guesses_[r], changes[r]));
    return result;
  }

  /// Of each robot: its rows' differences, and its changes in units of their doubt.
  std::vector<Eigen::VectorXd> errors(const std::vector<Change>& changes) const {
    const std::vector<StartState> from = starts(changes);
    ReplayedRobots robots(traces_, models_, from, ball_, config_);
    std::vector<Eigen::VectorXd> result(traces_.size(),
                                        Eigen::VectorXd(static_cast<Eigen::Index>(6 * rows_ + 12)));
    for (std::size_t i = 0; i < rows_; ++i) {
      if (i > 0) {
        robots.act(i);
        robots.world().step();
      }
      for (std::size_t r = 0; r < traces_.size(); ++r)
        result[r].segment<6>(static_cast<Eigen::Index>(6 * i)) =
            difference(traces_[r].rows[i], robots.sense(r, i));
    }
    for (std::size_t r = 0; r < traces_.size(); ++r)
      for (int k = 0; k < 12; ++k)
        result[r][static_cast<Eigen::Index>(6 * rows_) + k] = changes[r][k] / doubt[k / 3];
    return result;
  }

  const std::vector<LeagueTrace>& traces_;
  const std::vector<RobotModel>& models_;
  const BodyState& ball_;
  const WorldConfig& config_;
  std::vector<StartState> guesses_;
  std::size_t rows_ = 0;
};

}  // namespace

std::vector<StartState> fitStarts(const std::vector<LeagueTrace>& robots,
                                  const std::vector<RobotModel>& models, const BodyState& ball,
                                  const WorldConfig& config) {
  return StartFit(robots, models, ball, config).solve();
}

}  // namespace plumbline::simulation
