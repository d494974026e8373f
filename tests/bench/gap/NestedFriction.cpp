#include "NestedFriction.h"

#include <cmath>

#include "Shares.h"
#include "framework/Parallel.h"
#include "gap/effects/Effects.h"
#include "optimization/Cmaes.h"

namespace plumbline::bench {

using namespace gap;

namespace {

constexpr int evaluationsPerTerm = 40;
constexpr double firstStep = 0.05;  // of the bounds

class Models {
public:
  Models(const Mechanism& robot, const ChainReplay& chain, int jobs)
      : robot_(robot), chain_(chain), jobs_(jobs) {
    for (const char* id : {"coulomb_friction", "viscous_friction", "stribeck_friction", "load_friction"}) {
      const Effect* effect = findEffect(id);
      const std::string& name = robot_.joints[static_cast<std::size_t>(chain_.joint())].name;
      terms_.push_back({effect, findPlace(*effect, robot_, name, ""), 0, 0});
    }
  }

  Explanation best() const {
    Eigen::VectorXd chosen(0), shares(0);
    double least = chain_.of({}).judging;
    while (static_cast<std::size_t>(shares.size()) < terms_.size()) {
      shares = fitted(shares);
      const double judging = chain_.of(at(shares)).judging;
      if (judging < least) least = judging, chosen = shares;
    }
    if (chosen.size() == 0) return {};
    Eigen::Index telling = 0;
    double most = -INFINITY;
    for (Eigen::Index i = 0; i < chosen.size(); ++i) {
      Eigen::VectorXd without = chosen;
      without[i] = 0;
      const double judging = chain_.of(at(without)).judging;
      if (judging > most) most = judging, telling = i;
    }
    return {atShare(robot_, terms_[static_cast<std::size_t>(telling)], chosen[telling])};
  }

private:
  Explanation at(const Eigen::VectorXd& shares) const {
    Explanation causes;
    for (Eigen::Index i = 0; i < shares.size(); ++i)
      if (shares[i] > 0) causes.push_back(atShare(robot_, terms_[static_cast<std::size_t>(i)], shares[i]));
    return causes;
  }

  /// The model with one more term, from where the one before came out.
  Eigen::VectorXd fitted(const Eigen::VectorXd& before) const {
    const Eigen::Index n = before.size() + 1;
    SearchSpace space;
    space.start = Eigen::VectorXd::Zero(n);
    space.start.head(n - 1) = before;
    space.sigma = Eigen::VectorXd::Constant(n, firstStep);
    space.lower = Eigen::VectorXd::Zero(n);
    space.upper = Eigen::VectorXd::Ones(n);
    CmaesOptions options;
    options.seed = 7;
    options.stop.maxEvaluations = evaluationsPerTerm * n;
    options.stop.tolX = 0.005;
    Cmaes optimizer(space, options);
    while (!optimizer.isDone()) {
      const Eigen::MatrixXd& asked = optimizer.ask();
      std::vector<double> costs(static_cast<std::size_t>(asked.cols()));
      parallel(costs.size(), jobs_, [&](std::size_t i) {
        costs[i] = chain_.of(at(asked.col(static_cast<Eigen::Index>(i)))).fitting;
      });
      optimizer.tell(costs);
    }
    return optimizer.bestCost() < chain_.of(at(space.start)).fitting ? optimizer.best() : space.start;
  }

  const Mechanism& robot_;
  const ChainReplay& chain_;
  const int jobs_;
  Explanation terms_;
};

}  // namespace

Explanation nestedFriction(const Mechanism& robot, const ChainReplay& chain, int jobs) {
  if (chain.joint() < 0) return {};
  return Models(robot, chain, jobs).best();
}

}  // namespace plumbline::bench
