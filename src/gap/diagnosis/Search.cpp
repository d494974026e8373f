#include "gap/diagnosis/Search.h"

#include <algorithm>
#include <cmath>

#include "gap/diagnosis/Parallel.h"
#include "optimization/Cmaes.h"

namespace plumbline::gap {

namespace {

constexpr double cleanChi =
    0.35;  // mean square beyond noise, in a channel, below which a chain counts as clean
constexpr double chainShare = 0.02;  // of the worst joint's excess: chains below that wait for a later round
constexpr double jointShare = 0.03;  // of the chain's worst
constexpr std::size_t lookTwice = 60, leastRefined = 4;
constexpr double refineShare = 0.2;  // of the best first look's gain: what promises less is not fitted

struct Bounds {
  double lower, upper;
};

Bounds boundsOf(const Mechanism& mechanism, const Cause& cause) {
  const Effect& e = *cause.effect;
  if (e.nominal != 0) return {e.lower, e.upper};
  const double scale = e.scaleAt(mechanism, cause.place);
  return {e.lower * scale, e.upper * scale};
}

/// The cause with its distance from nominal multiplied, held within bounds.
Cause scaled(const Mechanism& mechanism, Cause cause, double share) {
  const Bounds bounds = boundsOf(mechanism, cause);
  const double nominal = cause.effect->nominal;
  cause.value = std::clamp(nominal + share * (cause.value - nominal), bounds.lower, bounds.upper);
  return cause;
}

}  // namespace

namespace {

/// Joints that runs with a held base show to be off: themselves, and in a chain of which any is.
struct Suspects {
  std::vector<double> excess;  ///< per joint: mean square beyond noise in its worst run
  std::vector<bool> joint, chain;
  bool any = false;
};

Suspects suspectsOf(const Evaluator& evaluator) {
  const Mechanism& robot = evaluator.mechanism();
  const auto& trials = evaluator.evidence().trials();
  const std::size_t n = robot.joints.size();
  Suspects result{std::vector<double>(n, 0), std::vector<bool>(n), std::vector<bool>(n)};
  for (std::size_t t = 0; t < trials.size(); ++t)
    for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
      const Signal& signal = trials[t].signals[s];
      if (trials[t].freeBase || signal.kind != SignalKind::position) continue;
      double& most = result.excess[static_cast<std::size_t>(signal.joint)];
      most = std::max(most, evaluator.chi(t, s) - 1);
    }
  const double all = *std::ranges::max_element(result.excess);
  for (std::size_t j = 0; j < n; ++j) {
    double chain = 0;
    const std::vector<int> near =
        evaluator.jointsTouched({nullptr, {Site::joint, static_cast<int>(j), ""}, 0, 0});
    for (const int other : near) chain = std::max(chain, result.excess[static_cast<std::size_t>(other)]);
    result.chain[j] = chain > std::max(cleanChi, chainShare * all);
    result.joint[j] = result.chain[j] && result.excess[j] > jointShare * chain;
    result.any = result.any || result.chain[j];
  }
  if (!evaluator.hasHeld()) {
    result.chain.assign(n, true);
    result.joint.assign(n, true);
    result.any = true;
  }
  return result;
}

bool measured(const Evidence& data, SignalKind a, SignalKind b) {
  return std::ranges::any_of(data.trials(), [&](const Trial& trial) {
    return std::ranges::any_of(trial.signals, [&](const Signal& s) { return s.kind == a || s.kind == b; });
  });
}

/// Whether an effect at a joint can show elsewhere in the chain more than at the joint itself.
bool showsElsewhere(const Effect& effect) {
  return effect.id == "joint_offset" || effect.id == "encoder_nonlinearity";
}

}  // namespace

std::vector<Cause> possibleCauses(const Evaluator& evaluator) {
  const Mechanism& robot = evaluator.mechanism();
  const Suspects suspects = suspectsOf(evaluator);
  const bool imu = measured(evaluator.evidence(), SignalKind::gyro, SignalKind::accelerometer);
  const bool forces = measured(evaluator.evidence(), SignalKind::force, SignalKind::force);
  const auto possible = [&](const Effect& effect, const Place& place) {
    const auto index = static_cast<std::size_t>(place.index);
    switch (place.site) {
      case Site::imu:
        return imu;
      case Site::foot:
        return forces;
      case Site::ground:
        return evaluator.hasStanding();
      case Site::everywhere:
        return suspects.any &&
               (effect.id != "speed_limit" || robot.joints[0].servo.model != Servo::Model::dcMotor);
      case Site::joint:
        if (effect.id == "speed_limit" && robot.joints[index].servo.model == Servo::Model::dcMotor)
          return false;
        return suspects.joint[index] || (suspects.chain[index] && showsElsewhere(effect));
      case Site::link: {
        const std::vector<int> chain = robot.chain(place.index);
        if (chain.empty()) return evaluator.hasStanding();
        return static_cast<bool>(suspects.chain[static_cast<std::size_t>(chain.back())]);
      }
    }
    return false;
  };
  std::vector<Cause> causes;
  for (const Effect* effect : effects())
    for (const Place& place : placesOf(*effect, robot)) {
      if (!possible(*effect, place)) continue;
      const double scale = effect->nominal != 0 ? 1 : effect->scaleAt(robot, place);
      for (int variant = 0; variant < effect->numVariants(); ++variant)
        for (const double start : effect->starts) causes.push_back({effect, place, start * scale, variant});
    }
  return causes;
}

Candidate fitValue(const Evaluator& evaluator, const Cause& start, const TrialMask& mask) {
  const Mechanism& robot = evaluator.mechanism();
  const Bounds bounds = boundsOf(robot, start);
  const double nominal = start.effect->nominal;
  const double distance = std::abs(start.value - nominal), sign = start.value < nominal ? -1 : 1;
  const double most = std::max(1e-12, sign > 0 ? bounds.upper - nominal : nominal - bounds.lower);
  Candidate best;
  best.fit.fitting = INFINITY;
  const auto evaluate = [&](double logShare) {
    Cause cause = start;
    cause.value = nominal + sign * std::min(most, distance * std::exp(logShare));
    Fit fit = evaluator.with(cause, mask);
    const double cost = fit.fitting;
    if (cost < best.fit.fitting) best = {cause, std::move(fit), 0};
    return cost;
  };
  // A bracket, then Brent (Algorithms for Minimization without Derivatives, 1973, chapter 5).
  const double top = std::log(most / distance);
  double a = -0.5, b = 0, c = std::min(0.5, top);
  if (c <= b) c = top, b = top - 0.3, a = top - 0.8;
  double fb = evaluate(b), fa = evaluate(a), fc = evaluate(c);
  for (int i = 0; i < 8 && (fa < fb || fc < fb); ++i) {
    if (fa < fb) {
      c = b, fc = fb, b = a, fb = fa;
      a = b - 1.6 * (c - b);
      fa = evaluate(a);
    } else {
      if (c >= top) break;
      a = b, fa = fb, b = c, fb = fc;
      c = std::min(top, b + 1.6 * (b - a));
      fc = evaluate(c);
    }
  }
  double x = b, w = fa < fc ? a : c, v = fa < fc ? c : a, fx = fb, fw = std::min(fa, fc),
         fv = std::max(fa, fc);
  double lo = a, hi = c, step = 0, stepBefore = 0;
  for (int i = 0; i < 9; ++i) {
    const double middle = (lo + hi) / 2, tolerance = 0.004;
    if (std::abs(x - middle) <= 2 * tolerance - (hi - lo) / 2) break;
    bool golden = true;
    if (std::abs(stepBefore) > tolerance || i == 0) {
      const double r = (x - w) * (fx - fv), q0 = (x - v) * (fx - fw);
      double p = (x - v) * q0 - (x - w) * r, q = 2 * (q0 - r);
      if (q > 0) p = -p;
      q = std::abs(q);
      if (q > 0 && p > q * (lo - x) && p < q * (hi - x) &&
          (i == 0 || std::abs(p) < std::abs(0.5 * q * stepBefore))) {
        stepBefore = step;
        step = p / q;
        golden = false;
      }
    }
    if (golden) {
      stepBefore = x < middle ? hi - x : lo - x;
      step = 0.381966 * stepBefore;
    }
    const double u = x + (std::abs(step) >= tolerance ? step : std::copysign(tolerance, step));
    const double fu = evaluate(u);
    if (fu <= fx) {
      (u < x ? hi : lo) = x;
      v = w, fv = fw, w = x, fw = fx, x = u, fx = fu;
    } else {
      (u < x ? lo : hi) = u;
      if (fu <= fw || w == x) {
        v = w, fv = fw, w = u, fw = fu;
      } else if (fu <= fv || v == x || v == w) {
        v = u, fv = fu;
      }
    }
  }
  return best;
}

namespace {

/// Trials that tell most about what is unexplained: of each base, the two with the largest excess, repeats
/// once.
TrialMask tellingTrials(const Evaluator& evaluator) {
  const auto& trials = evaluator.evidence().trials();
  TrialMask mask(trials.size(), 0);
  for (const bool standing : {false, true}) {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t t = 0; t < trials.size(); ++t) {
      if (trials[t].freeBase != standing) continue;
      double excess = 0;
      for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
        const double chi = evaluator.chi(t, s);
        if (Evidence::counts(trials[t].signals[s]) && std::isfinite(chi)) excess += std::max(0.0, chi - 1);
      }
      order.emplace_back(-excess, t);
    }
    std::ranges::sort(order);
    std::vector<std::size_t> taken;
    for (const auto& [excess, t] : order) {
      if (taken.size() >= 2) break;
      if (std::ranges::none_of(
              taken, [&, t = t](std::size_t other) { return isRepeat(trials[other], trials[t]); })) {
        taken.push_back(t);
        mask[t] = 1;
      }
    }
  }
  return mask;
}

}  // namespace

std::vector<Candidate> search(const Evaluator& evaluator, const Evaluator& coarse,
                              const std::vector<Cause>& causes, const SearchOptions& options) {
  const Mechanism& robot = evaluator.mechanism();
  const auto& trials = evaluator.evidence().trials();
  std::vector<Candidate> looked(causes.size());
  std::atomic<std::size_t> done = 0;
  const auto tell = [&](double from, double to, std::size_t all) {
    const double share = static_cast<double>(++done) / static_cast<double>(std::max<std::size_t>(all, 1));
    if (options.progress) options.progress(from + (to - from) * share);
  };
  // What a held run can show, it shows for a hundredth of a standing run's price.
  const auto maskOf = [&](const Cause& cause, TrialMask mask) {
    const Site site = cause.place.site;
    const bool bodyOnly = site == Site::foot || site == Site::ground || site == Site::imu ||
                          (site == Site::link && evaluator.jointsTouched(cause).empty());
    for (std::size_t t = 0; t < trials.size(); ++t) {
      if (trials[t].freeBase && evaluator.hasHeld() && !bodyOnly) mask[t] = 0;
      if (!trials[t].freeBase && bodyOnly && site != Site::imu) mask[t] = 0;
    }
    return mask;
  };
  const TrialMask telling = tellingTrials(evaluator), every(trials.size(), 1);
  parallel(causes.size(), options.jobs, [&](std::size_t i) {
    Candidate& candidate = looked[i];
    candidate.cause = causes[i];
    const Fit fit = coarse.with(causes[i], maskOf(causes[i], telling));
    const double share = std::clamp(fit.bestShare(), 0.0, 5.0);
    candidate.screened = 2 * share * fit.product - share * share * fit.change;
    const double gain = coarse.baseFit().fitting - fit.fitting;
    if (gain > candidate.screened)
      candidate.screened = gain;
    else if (share > 0.02)
      candidate.cause = scaled(robot, causes[i], share);
    tell(0, 0.5, causes.size());
  });
  // The best start of each kind and variant.
  std::stable_sort(looked.begin(), looked.end(),
                   [](const Candidate& a, const Candidate& b) { return a.screened > b.screened; });
  std::vector<Candidate> chosen;
  for (const Candidate& candidate : looked) {
    if (chosen.size() >= lookTwice || candidate.screened <= 0) break;
    const bool known = std::ranges::any_of(chosen, [&](const Candidate& c) {
      return c.cause.sameKind(candidate.cause) && c.cause.variant == candidate.cause.variant &&
             (c.cause.value < c.cause.effect->nominal) ==
                 (candidate.cause.value < candidate.cause.effect->nominal);
    });
    if (!known) chosen.push_back(candidate);
  }
  // What the scaled change promises need not come true where an effect is far from linear: a second look
  // there.
  parallel(chosen.size(), options.jobs, [&](std::size_t i) {
    Candidate& candidate = chosen[i];
    const TrialMask mask = maskOf(candidate.cause, telling);
    const double base = coarse.baseFit().fitting;
    Fit fit = coarse.with(candidate.cause, mask);
    double gain = base - fit.fitting;
    const double share = std::clamp(fit.bestShare(), 0.3, 3.0);
    if (std::abs(share - 1) > 0.05) {
      const Cause further = scaled(robot, candidate.cause, share);
      const double again = base - coarse.with(further, mask).fitting;
      if (again > gain) gain = again, candidate.cause = further;
    }
    candidate.screened = gain;
  });
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const Candidate& a, const Candidate& b) { return a.screened > b.screened; });
  while (!chosen.empty() &&
         (chosen.size() > options.refine || chosen.back().screened <= refineShare * chosen.front().screened ||
          chosen.back().screened <= 0)) {
    if (chosen.back().screened > 0 && chosen.size() <= leastRefined) break;
    chosen.pop_back();
  }
  done = 0;
  parallel(chosen.size(), options.jobs, [&](std::size_t i) {
    const double screened = chosen[i].screened;
    const Cause start = chosen[i].cause;
    const TrialMask all = maskOf(start, every);
    // Standing runs are dear: the value is fitted on those that tell most, then judged on all.
    TrialMask fitted = all;
    for (std::size_t t = 0; t < trials.size(); ++t)
      if (trials[t].freeBase) fitted[t] = all[t] && telling[t];
    chosen[i] = fitValue(evaluator, start, fitted);
    if (fitted != all) chosen[i].fit = evaluator.with(chosen[i].cause, all);
    chosen[i].screened = screened;
    tell(0.5, 1, chosen.size());
  });
  std::erase_if(chosen, [&](const Candidate& c) { return c.fit.fitting >= evaluator.baseFit().fitting; });
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const Candidate& a, const Candidate& b) { return a.fit.judging < b.fit.judging; });
  // One of each kind: its better variant.
  std::vector<Candidate> result;
  for (Candidate& candidate : chosen) {
    if (std::ranges::none_of(result, [&](const Candidate& c) { return c.cause.sameKind(candidate.cause); }))
      result.push_back(std::move(candidate));
  }
  return result;
}

Explanation fitTogether(const Evaluator& evaluator, const Explanation& causes, int evaluations, int jobs) {
  const Mechanism& mechanism = evaluator.mechanism();
  const auto n = static_cast<Eigen::Index>(causes.size());
  // Coordinates: logarithm of each distance from nominal against where it is now.
  SearchSpace space;
  space.start = Eigen::VectorXd::Zero(n);
  space.sigma = Eigen::VectorXd::Constant(n, 0.15);
  space.lower = Eigen::VectorXd::Constant(n, -2);
  space.upper = Eigen::VectorXd::Zero(n);
  const auto at = [&](const Eigen::VectorXd& x) {
    Explanation tried = causes;
    for (Eigen::Index i = 0; i < n; ++i) {
      auto& cause = tried[static_cast<std::size_t>(i)];
      cause = scaled(mechanism, cause, std::exp(x[i]));
    }
    return tried;
  };
  for (Eigen::Index i = 0; i < n; ++i) {
    const Cause& cause = causes[static_cast<std::size_t>(i)];
    const Bounds bounds = boundsOf(mechanism, cause);
    const double nominal = cause.effect->nominal, distance = std::abs(cause.value - nominal);
    const double most = cause.value < nominal ? nominal - bounds.lower : bounds.upper - nominal;
    space.upper[i] =
        std::max(0.01, std::min(2.0, std::log(std::max(most, 1e-12) / std::max(distance, 1e-12))));
  }
  CmaesOptions options;
  options.seed = 7;
  options.population = 8;
  options.stop.maxEvaluations = evaluations;
  options.stop.tolX = 0.02;
  options.stop.tolFun = 0.5;
  Cmaes optimizer(space, options);
  while (!optimizer.isDone()) {
    const Eigen::MatrixXd& asked = optimizer.ask();
    std::vector<double> costs(static_cast<std::size_t>(asked.cols()));
    parallel(costs.size(), jobs, [&](std::size_t i) {
      costs[i] = evaluator.of(at(asked.col(static_cast<Eigen::Index>(i)))).fitting;
    });
    optimizer.tell(costs);
  }
  const Explanation fitted = at(optimizer.best());
  return optimizer.bestCost() < evaluator.of(causes).fitting ? fitted : causes;
}

}  // namespace plumbline::gap
