#include "PeerFits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <stdexcept>

#include "gap/effects/Effects.h"
#include "gap/inference/CandidateScreening.h"
#include "gap/inference/Fit.h"
#include "gap/inference/Strengths.h"
#include "math/Random.h"
#include "optimization/Cmaes.h"

namespace plumbline::bench {

using namespace gap;

namespace {

using Ids = std::vector<std::string_view>;

/// What MuJoCo's system identification and PACE fit, and the frictions, gains and limits beside: of every
/// joint.
Ids everything() {
  Ids ids;
  for (const Effect* effect : actuatorEffects()) ids.push_back(effect->id);
  return ids;
}

/// Duclusaud et al., "Extended Friction Models for the Physics Simulation of Servo Actuators", 2024, table 1;
/// with the rotor's inertia, which their fits have too.
const std::array<Ids, 6> frictionModels{
    Ids{"rotor_inertia", "coulomb_friction", "viscous_friction"},
    Ids{"rotor_inertia", "coulomb_friction", "viscous_friction", "stribeck_friction"},
    Ids{"rotor_inertia", "coulomb_friction", "viscous_friction", "load_friction"},
    Ids{"rotor_inertia", "coulomb_friction", "viscous_friction", "stribeck_friction", "load_friction",
        "load_stribeck_friction"},
    Ids{"rotor_inertia", "coulomb_friction", "viscous_friction", "stribeck_friction", "load_friction",
        "load_stribeck_friction", "link_load_friction"},
    Ids{"rotor_inertia", "coulomb_friction", "viscous_friction", "stribeck_friction", "load_friction",
        "load_stribeck_friction", "link_load_friction", "quadratic_load_friction"}};

/// What MuJoCo's system identification tunes of a position actuator, and what PACE (Bjelonic et al. 2025)
/// does.
const Ids mujoco{"rotor_inertia", "viscous_friction", "coulomb_friction", "servo_gain"},
    pace{"rotor_inertia", "viscous_friction", "coulomb_friction", "joint_offset", "command_delay"};

constexpr int gaussNewtonSteps = 15, singleSteps = 8;
constexpr int evaluationsTogether = 3000;  // of CMA-ES, shared among the motors
constexpr int randomStarts = 8;            // of Gauss-Newton, likewise
constexpr std::size_t singlesTried = 8;

double cpuNow() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A start with a way of building load friction (its variants) and, by a seed other than 0, values at random
/// up to three times the least that a search starts from.
PerJoint startOf(const Mechanism& robot, PerJoint start, int variant, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = start.causes.size() - start.parameters; i < start.causes.size(); ++i) {
    Cause& cause = start.causes[i];
    if (cause.effect->id == "load_friction") cause.variant = variant;
    if (seed == 0) continue;
    cause = withStrength(robot, cause, random.uniform(0, 3) * leastStart(robot, cause));
  }
  return start;
}

std::size_t motorsOf(const Mechanism& robot) {
  std::size_t motors = 0;
  for (int joint = 0; joint < robot.numJoints(); ++joint) motors += robot.motorOf(joint) == joint;
  return motors;
}

}  // namespace

Peers::Peers(const Mechanism& robot, std::vector<Trial> segments, int jobs)
    : robot_(robot), groups_(std::move(segments)), replayer_(robot_, groups_, jobs) {}

std::vector<std::string> Peers::names() const {
  std::vector<std::string> names{"single", "mujoco-gauss-newton", "pace-cma-es", "everything-gauss-newton",
                                 "everything-cma-es"};
  for (std::size_t model = 1; model <= frictionModels.size(); ++model)
    names.push_back("bam-m" + std::to_string(model));
  return names;
}

PeerFit Peers::fit(const std::string& name) const {
  const double before = cpuNow();
  PeerFit result;
  if (name == "single") {
    result = single();
  } else if (name == "everything-cma-es" || name == "pace-cma-es") {
    result = byCmaes(name == "pace-cma-es" ? pace : everything());
  } else if (name == "everything-gauss-newton" || name == "mujoco-gauss-newton") {
    result = byGaussNewton(name == "mujoco-gauss-newton" ? mujoco : everything(), {});
  } else {
    const auto model = static_cast<std::size_t>(name.back() - '1');
    // Each model begins where a smaller one came out, too: M3 has no friction at rest, so M4 goes on from M2.
    Explanation start;
    for (const std::size_t smaller : {std::size_t{1}, std::size_t{3}, std::size_t{4}})
      if (smaller < model) start = byGaussNewton(frictionModels[smaller], start).causes;
    result = byGaussNewton(frictionModels[model], start);
  }
  result.name = name;
  result.closedFitting = 1 - std::sqrt(shareLeft(replayer_, result.causes));
  result.cpuSeconds = cpuNow() - before;
  return result;
}

PeerFit Peers::byGaussNewton(const std::vector<std::string_view>& ids, const Explanation& before) const {
  const auto starts = std::max<std::uint64_t>(2, randomStarts / motorsOf(robot_));
  PerJoint best;
  best.left = HUGE_VAL;
  const bool byLoad = std::ranges::find(ids, "load_friction") != ids.end();
  for (int variant = 0; variant < (byLoad ? findEffect("load_friction")->numVariants() : 1); ++variant)
    for (std::uint64_t seed = 0; seed < starts; ++seed) {
      const PerJoint start = perJoint(robot_, seed == 0 ? before : Explanation(), ids);
      PerJoint fitted = fitPerJoint(replayer_, startOf(robot_, start, variant, seed), gaussNewtonSteps);
      if (fitted.left < best.left) best = std::move(fitted);
    }
  return {"", std::to_string(ids.size()) + " values per joint", best.causes, best.parameters, 0, 0};
}

PeerFit Peers::byCmaes(const std::vector<std::string_view>& ids) const {
  const PerJoint start = perJoint(robot_, {}, ids);
  const int evaluations = evaluationsTogether / static_cast<int>(motorsOf(robot_));
  const auto n = static_cast<Eigen::Index>(start.parameters);
  SearchSpace space;
  space.start = Eigen::VectorXd::Zero(n);
  space.sigma = Eigen::VectorXd::Constant(n, 0.3);
  space.lower.resize(n);
  space.upper.resize(n);
  std::vector<double> units;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Cause& cause = start.causes[static_cast<std::size_t>(i)];
    const Bounds bounds = cause.effect->boundsAt(robot_, cause.place);
    units.push_back(leastStart(robot_, cause));
    const double a = cause.effect->strengthOf(bounds.lower) / units.back(),
                 b = cause.effect->strengthOf(bounds.upper) / units.back();
    // A value that begins at its bound may go beyond it, where it does nothing more: a search needs room.
    space.lower[i] = std::min({a, b, -1.0});
    space.upper[i] = std::max({a, b, 1.0});
  }
  const auto at = [&](const Eigen::VectorXd& x) {
    Explanation causes = start.causes;
    for (Eigen::Index i = 0; i < n; ++i) {
      Cause& cause = causes[static_cast<std::size_t>(i)];
      cause = withStrength(robot_, cause, x[i] * units[static_cast<std::size_t>(i)]);
    }
    return causes;
  };
  CmaesOptions search;
  search.seed = 7;
  search.stop.maxEvaluations = evaluations;
  Cmaes optimizer(space, search);
  while (!optimizer.isDone()) {
    const Eigen::MatrixXd& asked = optimizer.ask();
    std::vector<double> costs;
    for (Eigen::Index i = 0; i < asked.cols(); ++i) costs.push_back(shareLeft(replayer_, at(asked.col(i))));
    optimizer.tell(costs);
  }
  return {"",
          std::to_string(ids.size()) + " values per joint, " + std::to_string(evaluations) + " replays",
          at(optimizer.best()),
          start.parameters,
          0,
          0};
}

PeerFit Peers::single() const {
  const gap::Shares shares = sharesOf(groups_, replayer_.residuals({}));
  PeerFit best;
  best.what = "none";
  double least = 1;
  for (const Proposal& proposal :
       CandidateScreening(replayer_, shares).propose(replayer_, {}, shares, singlesTried)) {
    const Explanation causes = gap::fit(replayer_, shares, {proposal.cause}, singleSteps).causes;
    const double left = shareLeft(replayer_, causes);
    if (left >= least) continue;
    least = left;
    best = {"", describe(causes.front()), causes, 1, 0, 0};
  }
  return best;
}

}  // namespace plumbline::bench
