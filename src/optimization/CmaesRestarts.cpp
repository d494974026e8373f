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

CmaesRestarts::CmaesRestarts(SearchSpace given, CmaesOptions options, Kind kind, int restarts)
    : Optimizer(std::move(given), options.stop),
      options_(withoutLimits(options)),
      kind_(kind),
      restarts_(restarts),
      current_(std::make_unique<Cmaes>(space(), options_)) {
  if (restarts_ < 0) throw std::invalid_argument("CmaesRestarts: restarts is " + std::to_string(restarts_));
  options_.population = current_->population();
}

void CmaesRestarts::update(std::span<const double> costs, std::span<const int>) {
  current_->tell(costs);
  (small_ ? usedBySmall_ : usedByLarge_) += static_cast<std::int64_t>(costs.size());
  if (!current_->isDone()) return;
  if (run_ >= restarts_)
    finished_ = current_->stopReason();
  else
    restart();
}

void CmaesRestarts::forget() {
  current_->tell(std::vector<double>(static_cast<std::size_t>(current_->population()),
                                     std::numeric_limits<double>::infinity()));
}

void CmaesRestarts::restart() {
  ++run_;
  CmaesOptions next = options_;
  next.seed = options_.seed + 0x9e3779b97f4a7c15ULL * static_cast<std::uint64_t>(run_);
  Random random(next.seed ^ 0x5bf0363526f1cd1dULL);
  SearchSpace from = space();
  small_ = kind_ == Kind::bipop && usedBySmall_ < usedByLarge_;
  if (!small_ && doublings_ < maxDoublings) ++doublings_;
  const double large = std::ldexp(options_.population, doublings_);
  if (small_) {
    const double u = random.uniform();
    const double size = options_.population * std::pow(0.5 * large / options_.population, u * u);
    next.population = std::max(options_.population, static_cast<int>(size));
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
      const double wide = std::ldexp(space().sigma[i], doublings_);
      from.start[i] = std::clamp(from.start[i] + wide * g, from.lower[i], from.upper[i]);
      if (!small_) from.sigma[i] = wide;
    }
  }
  current_ = std::make_unique<Cmaes>(std::move(from), next);
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
