#include "gap/diagnosis/Pairs.h"

#include <Eigen/Core>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>

#include "framework/Parallel.h"
#include "gap/diagnosis/PossibleCauses.h"
#include "gap/diagnosis/Probability.h"
#include "gap/diagnosis/ValueFit.h"
#include "gap/replay/Ensemble.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t fitted = 24, polished = 4;  // pairs
constexpr int weakened = 4;  // times at most, until a start changes no more than there is
constexpr double leastTimes = 0.05, mostTimes = 5;  // times a start: as far as its signature says anything

/// A cause and what it changes: on the blocks for fitting, over the noise.
struct Signature {
  Cause cause;
  Eigen::VectorXd change;
};

/// use(trial, signal, cycle, weight, residual) for each sample to fit to.
template <class Use>
void forEachSample(const Evaluator& evaluator, Use&& use) {
  const Evidence& data = evaluator.evidence();
  for (std::size_t t = 0; t < data.trials().size(); ++t)
    for (std::size_t s = 0; s < data.trials()[t].signals.size(); ++s)
      data.forEach(t, s, evaluator.basePrediction(t), [&](std::size_t k, double w, double r) {
        if (Evidence::forFitting(data.block(t, k))) use(t, s, k, w, r);
      });
}

Eigen::VectorXd residuals(const Evaluator& evaluator) {
  std::vector<double> values;
  forEachSample(evaluator, [&](std::size_t, std::size_t, std::size_t, double w, double r) {
    values.push_back(std::sqrt(w) * r);
  });
  return Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

Eigen::VectorXd changeBy(const Cause& cause, const Evaluator& evaluator) {
  const std::vector<Prediction> played = evaluator.played({cause});
  std::vector<double> values;
  forEachSample(evaluator, [&](std::size_t t, std::size_t s, std::size_t k, double w, double) {
    double d = 0;
    if (!played[t].values.empty() && !played[t].values[s].empty())
      d = played[t].values[s][k] - evaluator.basePrediction(t).values[s][k];
    values.push_back(std::isfinite(d) ? std::sqrt(w) * d : 0);
  });
  return Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// One start of each kind, variant and side of nominal, weakened to what there is to explain.
std::vector<Signature> signatures(const Evaluator& evaluator, int jobs) {
  std::vector<Signature> list;
  for (const Cause& start : possibleCauses(evaluator)) {
    const auto below = [](const Cause& cause) { return cause.value < cause.effect->nominal; };
    const auto same = [&](const Signature& s) {
      return s.cause.sameKind(start) && s.cause.variant == start.variant && below(s.cause) == below(start);
    };
    if (anyLimitCycle(plantOf(evaluator.mechanism(), {start})) || std::ranges::any_of(list, same)) continue;
    list.push_back({start, {}});
  }
  const double whole = evaluator.baseFit().fitting;
  parallel(list.size(), jobs, [&](std::size_t i) {
    list[i].change = changeBy(list[i].cause, evaluator);
    for (int n = 0; n < weakened && list[i].change.squaredNorm() > whole; ++n) {
      const double share = std::sqrt(whole / list[i].change.squaredNorm()) / 2;
      list[i].cause = scaled(evaluator.mechanism(), list[i].cause, share);
      list[i].change = changeBy(list[i].cause, evaluator);
    }
  });
  std::erase_if(list, [](const Signature& s) { return !(s.change.squaredNorm() > 0); });
  return list;
}

struct Pair {
  Explanation causes;
  double left = INFINITY;  ///< squares
};

/// The two with the shares of their signatures that explain most, neither the other way round than its start;
/// nothing where one alone explains as much.
Pair linearly(const Signature& a, const Signature& b, const Eigen::VectorXd& r, const Mechanism& robot) {
  const double aa = a.change.squaredNorm(), bb = b.change.squaredNorm(), ab = a.change.dot(b.change),
               ra = r.dot(a.change), rb = r.dot(b.change), det = aa * bb - ab * ab;
  if (!(det > 1e-9 * aa * bb)) return {};
  const double x = (ra * bb - rb * ab) / det, y = (rb * aa - ra * ab) / det;
  if (!(x > 0) || !(y > 0)) return {};
  return {{scaled(robot, a.cause, std::clamp(x, leastTimes, mostTimes)),
           scaled(robot, b.cause, std::clamp(y, leastTimes, mostTimes))},
          r.squaredNorm() - x * ra - y * rb};
}

/// Those that leave least come first; one of each two kinds.
void keepBest(std::vector<Pair>& pairs, std::size_t count) {
  std::ranges::stable_sort(pairs, {}, &Pair::left);
  std::vector<Pair> kept;
  for (Pair& pair : pairs) {
    if (kept.size() == count || !std::isfinite(pair.left)) break;
    const auto same = [&](const Pair& other) {
      return other.causes[0].sameKind(pair.causes[0]) && other.causes[1].sameKind(pair.causes[1]);
    };
    if (std::ranges::none_of(kept, same)) kept.push_back(std::move(pair));
  }
  pairs = std::move(kept);
}

std::vector<Pair> promising(const Evaluator& evaluator, int jobs) {
  const std::vector<Signature> list = signatures(evaluator, jobs);
  const Eigen::VectorXd r = residuals(evaluator);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < list.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!list[i].cause.sameKind(list[j].cause))
        pairs.push_back(linearly(list[j], list[i], r, evaluator.mechanism()));
  keepBest(pairs, fitted);
  return pairs;
}

}  // namespace

bool hasOneMotor(const Mechanism& robot) {
  std::set<int> motors;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) motors.insert(robot.motorOf(static_cast<int>(i)));
  return motors.size() == 1;
}

bool onOneChain(const Evaluator& evaluator, const Explanation& causes) {
  std::vector<int> joints;
  for (const Cause& cause : causes) {
    std::vector<int> touched = evaluator.jointsTouched(cause);
    if (cause.place.site == Site::everywhere || touched.empty()) return false;
    std::ranges::sort(touched);
    if (!joints.empty() && touched != joints) return false;
    joints = std::move(touched);
  }
  return !joints.empty();
}

Explanation bestPair(const Evaluator& fine, const Evaluator& coarse, int jobs,
                     const std::function<void(double)>& progress) {
  std::vector<Pair> pairs = promising(coarse, jobs);
  std::atomic<std::size_t> done = 0;
  const double whole = static_cast<double>(pairs.size() + polished);
  const auto report = [&] {
    const std::size_t n = ++done;
    if (progress) progress(static_cast<double>(n) / whole);
  };
  parallel(pairs.size(), jobs, [&](std::size_t i) {
    pairs[i].causes = fitTogether(coarse, pairs[i].causes, 1);
    pairs[i].left = coarse.of(pairs[i].causes).fitting;
    report();
  });
  keepBest(pairs, polished);
  parallel(pairs.size(), jobs, [&](std::size_t i) {
    pairs[i].causes = fitSettled(fine, pairs[i].causes, 1);
    const double judging = fine.of(pairs[i].causes).judging;
    pairs[i].left = judging;
    for (const Cause& cause : pairs[i].causes) pairs[i].left += withPrior(cause, judging) - judging;
    report();
  });
  keepBest(pairs, 1);
  return pairs.empty() ? Explanation{} : pairs.front().causes;
}

}  // namespace plumbline::gap
