#include "optimization/CmaesRestarts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "math/Random.h"
#include "optimization/Optimizers.h"

namespace plumbline {
namespace {

constexpr int maxDoublings = 12;

/// What the runs keep of the criteria: the limits are counted over all of them.
CmaesOptions withoutLimits(CmaesOptions options) {
  StopCriteria stop;
  stop.tolFun = options.stop.tolFun;
  stop.tolX = options.stop.tolX;
  options.stop = stop;
  return options;
}

}  // namespace

CmaesRestarts::CmaesRestarts(SearchSpace space_, CmaesOptions options_, Kind kind_, int restarts_)
    : Optimizer(std::move(space_), options_.stop),
      options(withoutLimits(options_)),
      kind(kind_),
      restarts(restarts_),
      current(std::make_unique<Cmaes>(space(), options)) {
  if (restarts < 0) throw std::invalid_argument("CmaesRestarts: restarts is " + std::to_string(restarts));
  options.population = current->population();
}

void CmaesRestarts::update(std::span<const double> costs, std::span<const int>) {
  current->tell(costs);
  (small ? usedBySmall : usedByLarge) += static_cast<std::int64_t>(costs.size());
  if (!current->isDone()) return;
  if (run >= restarts)
    finished = current->stopReason();
  else
    restart();
}

void CmaesRestarts::forget() {
  current->tell(std::vector<double>(static_cast<std::size_t>(current->population()),
                                    std::numeric_limits<double>::infinity()));
}

void CmaesRestarts::restart() {
  ++run;
  CmaesOptions next = options;
  next.seed = options.seed + 0x9e3779b97f4a7c15ULL * static_cast<std::uint64_t>(run);
  Random random(next.seed ^ 0x5bf0363526f1cd1dULL);
  SearchSpace from = space();
  small = kind == Kind::bipop && usedBySmall < usedByLarge;
  if (!small && doublings < maxDoublings) ++doublings;
  const double large = std::ldexp(options.population, doublings);
  if (small) {
    const double u = random.uniform();
    const double size = options.population * std::pow(0.5 * large / options.population, u * u);
    next.population = std::max(options.population, static_cast<int>(size));
    from.sigma *= std::pow(10, -2 * random.uniform());
  } else {
    next.population = static_cast<int>(large);
  }
  for (Eigen::Index i = 0; i < from.start.size(); ++i) {
    const double u = random.uniform(), g = random.gaussian();
    if (std::isfinite(from.lower[i]) && std::isfinite(from.upper[i])) {
      from.start[i] = from.lower[i] + u * (from.upper[i] - from.lower[i]);
    } else {
      // Nothing says how wide the place is: the same deviation again could be caught in the same minimum.
      const double wide = std::ldexp(space().sigma[i], doublings);
      from.start[i] = std::clamp(from.start[i] + wide * g, from.lower[i], from.upper[i]);
      if (!small) from.sigma[i] = wide;
    }
  }
  current = std::make_unique<Cmaes>(std::move(from), next);
}

namespace {

std::unique_ptr<Optimizer> makeRestarts(const SearchSpace& space, const OptimizerOptions& given,
                                        CmaesRestarts::Kind kind) {
  CmaesOptions options;
  options.population = given.population;
  options.seed = given.seed;
  options.stop = given.stop;
  return std::make_unique<CmaesRestarts>(space, options, kind);
}

}  // namespace

MAKE_OPTIMIZER(ipop, {"ipop-cmaes", 40, [](const SearchSpace& space, const OptimizerOptions& given) {
                        return makeRestarts(space, given, CmaesRestarts::Kind::ipop);
                      }});
MAKE_OPTIMIZER(bipop, {"bipop-cmaes", 50, [](const SearchSpace& space, const OptimizerOptions& given) {
                         return makeRestarts(space, given, CmaesRestarts::Kind::bipop);
                       }});

}  // namespace plumbline
