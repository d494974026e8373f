#include "FitOfEverything.h"

#include <algorithm>
#include <cmath>

#include "Shares.h"
#include "framework/Parallel.h"
#include "gap/effects/Effects.h"
#include "optimization/Cmaes.h"

namespace plumbline::bench {

using namespace gap;

namespace {

constexpr int evaluations = 450;
constexpr double leastGain = 0.1;  // of the sum of squares
// The first steps, in shares of the bounds: all together they change a tenth of what there is to explain.
constexpr double firstChange = 0.1, probe = 0.01, leastStep = 0.0005, mostStep = 0.01;
constexpr double pull = 0.2;  // to nominal: cost of a parameter at its bound, of the nominal sum of squares

/// One per effect: at the joint where it can be, on the first axis where it has any.
Explanation everything(const Mechanism& robot, int joint, bool imuRecorded) {
  const Mechanism::Joint& at = robot.joints[static_cast<std::size_t>(joint)];
  Explanation causes;
  for (const Effect* effect : effects()) {
    if (effect->id == "command_dropout" || effect->id == "external_force") continue;
    if (effect->id == "speed_limit" && at.servo.model == Servo::Model::dcMotor) continue;
    const std::vector<Place> places = placesOf(*effect, robot);
    const auto find = [&](Site site, int index) {
      return std::ranges::find_if(places, [&](const Place& p) { return p.site == site && p.index == index; });
    };
    auto place = find(Site::joint, joint);
    if (place == places.end()) place = find(Site::link, at.child);
    if (place == places.end()) place = find(Site::everywhere, -1);
    if (place == places.end() && imuRecorded) place = find(Site::imu, -1);
    if (place != places.end()) causes.push_back({effect, *place, effect->nominal, 0});
  }
  return causes;
}

/// Coordinates of the search: shares of the bounds. Where a value has one side only, the other is off
/// altogether: play or a profile, however small, moves differently from none, so it must be possible to have
/// none.
class Shares {
public:
  Shares(const Mechanism& robot, Explanation causes) : robot_(robot), causes_(std::move(causes)) {}

  Eigen::Index size() const { return static_cast<Eigen::Index>(causes_.size()); }
  Cause at(Eigen::Index i, double x) const {
    const Cause& cause = causes_[static_cast<std::size_t>(i)];
    if (boundOf(robot_, cause, false) >= cause.effect->nominal) x = std::max(0.0, x);
    if (boundOf(robot_, cause, true) <= cause.effect->nominal) x = std::min(0.0, x);
    return atShare(robot_, cause, x);
  }
  Explanation at(const Eigen::VectorXd& x) const {
    Explanation all;
    for (Eigen::Index i = 0; i < size(); ++i) {
      const Cause cause = at(i, x[i]);
      if (cause.value != cause.effect->nominal) all.push_back(cause);
    }
    return all;
  }

private:
  const Mechanism& robot_;
  const Explanation causes_;
};

}  // namespace

Explanation fitOfEverything(const Mechanism& robot, const ChainReplay& chain, bool imuRecorded, int jobs) {
  if (chain.joint() < 0) return {};
  const Shares shares(robot, everything(robot, chain.joint(), imuRecorded));
  const Eigen::Index n = shares.size();
  const double nominal = chain.of({}).fitting;
  SearchSpace space;
  space.start = Eigen::VectorXd::Zero(n);
  space.sigma = Eigen::VectorXd::Constant(n, mostStep);
  space.lower = Eigen::VectorXd::Constant(n, -1);
  space.upper = Eigen::VectorXd::Ones(n);
  parallel(static_cast<std::size_t>(n), jobs, [&](std::size_t k) {
    const auto i = static_cast<Eigen::Index>(k);
    const double change =
        std::max(chain.of({shares.at(i, probe)}).change, chain.of({shares.at(i, -probe)}).change);
    const double step =
        probe * std::sqrt(firstChange * nominal / static_cast<double>(n) / std::max(change, 1e-9));
    space.sigma[i] = std::clamp(step, leastStep, mostStep);
  });
  const auto cost = [&](const Eigen::VectorXd& x) {
    return chain.of(shares.at(x)).fitting + pull * nominal * x.squaredNorm();
  };
  CmaesOptions options;
  options.seed = 7;
  options.stop.maxEvaluations = evaluations;
  Cmaes optimizer(space, options);
  while (!optimizer.isDone()) {
    const Eigen::MatrixXd& asked = optimizer.ask();
    std::vector<double> costs(static_cast<std::size_t>(asked.cols()));
    parallel(costs.size(), jobs,
             [&](std::size_t i) { costs[i] = cost(asked.col(static_cast<Eigen::Index>(i))); });
    optimizer.tell(costs);
  }
  // The centre has less of the search's own scatter than any one candidate.
  const Eigen::VectorXd centre = optimizer.favourite();
  const double atCentre = cost(centre), least = std::min(atCentre, optimizer.bestCost());
  if (least > (1 - leastGain) * nominal) return {};
  const Eigen::VectorXd found = atCentre < optimizer.bestCost() ? centre : optimizer.best();
  Explanation named;
  double most = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Cause cause = shares.at(i, found[i]);
    if (cause.value == cause.effect->nominal || std::abs(found[i]) <= most) continue;
    most = std::abs(found[i]);
    named = {cause};
  }
  return named;
}

}  // namespace plumbline::bench
