#include "gap/inference/PerJointFit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "gap/effects/Effects.h"
#include "gap/inference/Density.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr double probe = 0.1;    // step of derivatives, in the least strength that a search starts from
constexpr double longest = 20;   // step of a value, in the same
constexpr double damped = 1e-2;  // at first, of the diagonal

/// Per group: one over the squares that the nominal model leaves.
std::vector<double> weightsOf(const Replayer& replayer) {
  std::vector<double> squares(replayer.groups().count(), 0.0);
  const Residuals nominal = replayer.residuals({});
  for (const Cell& cell : replayer.groups().cells())
    if (isPosition(replayer.groups(), cell)) squares[cell.group] += squaresOf(residualsOf(cell, nominal));
  for (double& s : squares) s = s > 0 ? 1 / (s * static_cast<double>(squares.size())) : 0;
  return squares;
}

/// The parameters of one motor.
struct Motor {
  std::vector<std::size_t> causes;
  double damping = damped;
  Eigen::MatrixXd normal;
  Eigen::VectorXd downhill;
};

class JointSteps {
public:
  JointSteps(const Replayer& replayer, PerJoint start, const Shrinkage& prior)
      : replayer_(replayer),
        robot_(replayer.mechanism()),
        weights_(weightsOf(replayer)),
        prior_(prior),
        at_(std::move(start)),
        first_(at_.causes.size() - at_.parameters) {
    for (std::size_t i = first_; i < at_.causes.size(); ++i) {
      motors_[at_.causes[i].place.index].causes.push_back(i);
      alike_[at_.causes[i].effect->id].push_back(i);
      units_.push_back(leastStart(robot_, at_.causes[i]));
    }
    residuals_ = replayer_.residuals(at_.causes);
    squares_ = squaresPerMotor(residuals_);
  }

  PerJoint run(int steps) {
    for (int step = 0; step < steps && at_.parameters > 0; ++step) {
      linearise();
      if (!advance()) break;
    }
    at_.left = total(squares_);
    return at_;
  }

private:
  /// The present cause moved to a coordinate, held within its bounds.
  Cause moved(std::size_t i, double x) const {
    return withStrength(robot_, at_.causes[i], x * units_[i - first_]);
  }

  double coordinate(const Explanation& causes, std::size_t i) const {
    return causes[i].effect->strengthOf(causes[i].value) / units_[i - first_];
  }

  /// The prior's penalty with the likeliest common value is own * sum of x^2 - sharedPrecision * (sum of
  /// x)^2, both over one effect's values in all motors.
  double sharedPrecision(std::size_t motors) const {
    const double own = prior_.own;
    return own > 0 ? own * own / (own * static_cast<double>(motors) + prior_.common) : 0;
  }
  double sharedPrecisionOf(std::size_t i) const {
    return sharedPrecision(alike_.at(at_.causes[i].effect->id).size());
  }

  /// The sum of the effect's present values in the other motors.
  double others(std::size_t i) const {
    double sum = 0;
    for (const std::size_t k : alike_.at(at_.causes[i].effect->id))
      if (k != i) sum += coordinate(at_.causes, k);
    return sum;
  }

  /// The part of the penalty that depends on one value, those of the other motors as they are.
  double penaltyOf(const Explanation& causes, std::size_t i) const {
    const double x = coordinate(causes, i), c = sharedPrecisionOf(i);
    return (prior_.own - c) * x * x - 2 * c * x * others(i);
  }

  double penalty(const Explanation& causes) const {
    double all = 0;
    for (const auto& [id, parameters] : alike_) {
      double sum = 0;
      for (const std::size_t i : parameters) {
        const double x = coordinate(causes, i);
        sum += x;
        all += prior_.own * x * x;
      }
      all -= sharedPrecision(parameters.size()) * sum * sum;
    }
    return all;
  }

  /// Per motor: its position's share of the whole.
  std::map<int, double> squaresPerMotor(const Residuals& of) const {
    std::map<int, double> sums;
    for (const Cell& cell : replayer_.groups().cells())
      if (isPosition(replayer_.groups(), cell))
        sums[motorOf(cell)] += weights_[cell.group] * squaresOf(residualsOf(cell, of));
    return sums;
  }

  /// Per motor: its squares and the penalty of its values.
  std::map<int, double> costsOf(std::map<int, double> squares, const Explanation& causes) const {
    for (const auto& [joint, motor] : motors_)
      for (const std::size_t i : motor.causes) squares[joint] += penaltyOf(causes, i);
    return squares;
  }

  int motorOf(const Cell& cell) const {
    return robot_.motorOf(replayer_.groups().trials()[cell.trial].signals[cell.signal].joint);
  }

  static double total(const std::map<int, double>& of) {
    double sum = 0;
    for (const auto& [motor, cost] : of) sum += cost;
    return sum;
  }

  void linearise() {
    std::size_t most = 0;
    for (auto& [joint, motor] : motors_) {
      const auto n = static_cast<Eigen::Index>(motor.causes.size());
      motor.normal = Eigen::MatrixXd::Zero(n, n);
      motor.downhill = Eigen::VectorXd::Zero(n);
      most = std::max(most, motor.causes.size());
    }
    std::vector<Residuals> shifted;
    std::vector<double> steps(at_.causes.size(), 0.0);
    for (std::size_t k = 0; k < most; ++k) {
      Explanation other = at_.causes;
      for (const auto& [joint, motor] : motors_) {
        if (k >= motor.causes.size()) continue;
        const std::size_t i = motor.causes[k];
        const double x = coordinate(at_.causes, i);
        for (const double way : {probe, -probe}) {
          other[i] = moved(i, x + way);
          steps[i] = coordinate(other, i) - x;
          if (steps[i] != 0) break;
        }
      }
      shifted.push_back(replayer_.residuals(other));
    }
    for (const Cell& cell : replayer_.groups().cells()) {
      const auto motor = motors_.find(motorOf(cell));
      if (!isPosition(replayer_.groups(), cell) || motor == motors_.end() ||
          !residuals_[cell.trial][cell.signal])
        continue;
      add(cell, motor->second, shifted, steps);
    }
    for (auto& [joint, motor] : motors_)
      for (std::size_t k = 0; k < motor.causes.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        const std::size_t i = motor.causes[k];
        const double c = sharedPrecisionOf(i);
        motor.normal(row, row) += prior_.own - c;
        motor.downhill[row] -= (prior_.own - c) * coordinate(at_.causes, i) - c * others(i);
      }
  }

  void add(const Cell& cell, Motor& motor, const std::vector<Residuals>& shifted,
           const std::vector<double>& steps) {
    const ResidualSeries& here = *residuals_[cell.trial][cell.signal];
    const auto n = static_cast<Eigen::Index>(motor.causes.size());
    Eigen::VectorXd slope(n);
    for (std::size_t c = cell.from; c < cell.to; ++c) {
      if (!std::isfinite(here[c])) continue;
      for (Eigen::Index k = 0; k < n; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const double step = steps[motor.causes[i]], there = (*shifted[i][cell.trial][cell.signal])[c];
        slope[k] = step != 0 && std::isfinite(there) ? (there - here[c]) / step : 0;
      }
      motor.normal.noalias() += weights_[cell.group] * slope * slope.transpose();
      motor.downhill.noalias() -= weights_[cell.group] * here[c] * slope;
    }
  }

  /// One step of a motor's values; a value at its bound that would go beyond it stays.
  void step(const Motor& motor, Explanation& causes) const {
    std::vector<std::size_t> free;
    for (std::size_t k = 0; k < motor.causes.size(); ++k) {
      const std::size_t i = motor.causes[k];
      const double push = motor.downhill[static_cast<Eigen::Index>(k)];
      if (push != 0 &&
          moved(i, coordinate(at_.causes, i) + (push > 0 ? 1e-3 : -1e-3)).value != at_.causes[i].value)
        free.push_back(k);
    }
    const auto n = static_cast<Eigen::Index>(free.size());
    if (n == 0) return;
    Eigen::MatrixXd normal(n, n);
    Eigen::VectorXd downhill(n);
    for (Eigen::Index a = 0; a < n; ++a) {
      const auto row = static_cast<Eigen::Index>(free[static_cast<std::size_t>(a)]);
      downhill[a] = motor.downhill[row];
      for (Eigen::Index b = 0; b < n; ++b)
        normal(a, b) = motor.normal(row, static_cast<Eigen::Index>(free[static_cast<std::size_t>(b)]));
    }
    normal.diagonal() *= 1 + motor.damping;
    normal.diagonal().array() += 1e-12;
    const Eigen::VectorXd way = normal.ldlt().solve(downhill).cwiseMax(-longest).cwiseMin(longest);
    for (Eigen::Index a = 0; a < n; ++a) {
      const std::size_t i = motor.causes[free[static_cast<std::size_t>(a)]];
      causes[i] = moved(i, coordinate(at_.causes, i) + way[a]);
    }
  }

  /// A step of all motors; those whose own position got worse go back and get more damping. False if none is
  /// better.
  bool advance() {
    const std::map<int, double> costs = costsOf(squares_, at_.causes);
    const double before = total(squares_) + penalty(at_.causes);
    for (int attempt = 0; attempt < 4; ++attempt) {
      Explanation tried = at_.causes;
      for (const auto& [joint, motor] : motors_) step(motor, tried);
      const std::map<int, double> there = costsOf(squaresPerMotor(replayer_.residuals(tried)), tried);
      for (auto& [joint, motor] : motors_) {
        if (costAt(there, joint) < costAt(costs, joint)) {
          motor.damping = std::max(1e-6, motor.damping / 8);
          continue;
        }
        motor.damping *= 8;
        for (const std::size_t i : motor.causes) tried[i] = at_.causes[i];
      }
      if (tried == at_.causes) continue;
      Residuals after = replayer_.residuals(tried);
      std::map<int, double> squares = squaresPerMotor(after);
      const double left = total(squares) + penalty(tried);
      if (left >= before) {
        for (auto& [joint, motor] : motors_) motor.damping *= 8;
        continue;
      }
      at_.causes = std::move(tried);
      residuals_ = std::move(after);
      squares_ = std::move(squares);
      return before - left > 1e-3 * before;
    }
    return false;
  }

  static double costAt(const std::map<int, double>& of, int joint) {
    const auto found = of.find(joint);
    return found == of.end() ? 0 : found->second;
  }

  const Replayer& replayer_;
  const Mechanism& robot_;
  const std::vector<double> weights_;
  const Shrinkage prior_;
  PerJoint at_;
  const std::size_t first_;  ///< the first parameter's place among the causes
  std::map<int, Motor> motors_;
  std::vector<double> units_;                                   ///< per parameter
  Residuals residuals_;                                         ///< of the present values
  std::map<int, double> squares_;                               ///< of these, per motor
  std::map<std::string_view, std::vector<std::size_t>> alike_;  ///< per effect: its parameters
};

/// Whether a cause at a place is in a joint's motor.
bool covers(const Mechanism& robot, const Place& place, int joint) {
  if (place.site == Site::joint) return place.index == joint;
  if (place.index < 0) return true;
  const auto& members = robot.groups[static_cast<std::size_t>(place.index)].joints;
  return std::ranges::find(members, joint) != members.end();
}

}  // namespace

std::vector<const Effect*> kindsAtJoints(const Explanation& causes) {
  std::vector<const Effect*> kinds;
  for (const Cause& cause : causes)
    if (sitsAtJoints(*cause.effect) && std::ranges::find(kinds, cause.effect) == kinds.end())
      kinds.push_back(cause.effect);
  return kinds;
}

PerJoint perJoint(const Mechanism& robot, const Explanation& base, std::span<const Effect* const> effects) {
  const auto ofThese = [&](const Cause& cause) {
    return std::ranges::find(effects, cause.effect) != effects.end();
  };
  PerJoint result;
  for (const Cause& cause : base)
    if (!ofThese(cause)) result.causes.push_back(cause);
  for (int joint = 0; joint < robot.numJoints(); ++joint) {
    if (robot.motorOf(joint) != joint) continue;
    for (const Effect* effect : effects) {
      Cause cause{effect,
                  {Site::joint, joint, robot.joints[static_cast<std::size_t>(joint)].name},
                  effect->nominal,
                  0};
      // A setting that is missing in a recording of one joint is so in those of the others: they lose them
      // together, with the power.
      for (const Cause& known : base)
        if (known.effect == effect) cause.inactiveIn = known.inactiveIn;
      for (const Cause& known : base) {
        if (known.effect != effect || !covers(robot, known.place, joint)) continue;
        cause.value = known.value;
        cause.variant = known.variant;
        cause.inactiveIn = known.inactiveIn;
        if (known.place.site == Site::joint) break;
      }
      result.causes.push_back(cause);
      ++result.parameters;
    }
  }
  return result;
}

PerJoint perJoint(const Mechanism& robot, const Explanation& base, std::span<const std::string_view> ids) {
  std::vector<const Effect*> list;
  for (const std::string_view id : ids) {
    list.push_back(findEffect(id));
    if (!list.back() || !sitsAtJoints(*list.back()))
      throw std::invalid_argument(std::string(id) + " is no effect of joints");
  }
  return perJoint(robot, base, list);
}

double shareLeft(const Replayer& replayer, const Explanation& causes) {
  const std::vector<double> weights = weightsOf(replayer);
  const Residuals residuals = replayer.residuals(causes);
  double sum = 0;
  for (const Cell& cell : replayer.groups().cells())
    if (isPosition(replayer.groups(), cell))
      sum += weights[cell.group] * squaresOf(residualsOf(cell, residuals));
  return sum;
}

PerJoint fitPerJoint(const Replayer& replayer, PerJoint start, int steps, const Shrinkage& prior) {
  return JointSteps(replayer, std::move(start), prior).run(steps);
}

}  // namespace plumbline::gap
