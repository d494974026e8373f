#include "gap/diagnosis/Diagnosis.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "gap/diagnosis/LostCycles.h"

namespace plumbline::gap {

namespace {

constexpr double present = 0.9;  // worst gap over noise below which nothing is looked for
constexpr double visible = 0.7;  // least change over noise, in some channel, of a cause that earns its place
constexpr double leastZ = 3;     // of the gain over blocks
constexpr double oneWay = 0.75;  // of the gains' absolute values
constexpr double leastShare = 0.05;       // of what is unexplained
constexpr double leastGain = 30;          // of the sum of squares
constexpr double unexplained = 1.3;       // worst gap over noise that may remain
constexpr double unexplainedShare = 0.2;  // the same, of what was there
constexpr double correlation = 8;         // samples per independent one
constexpr double engineShare = 0.0007;    // of a sum of squares, see temperature()
constexpr double rivalShare = 0.01;       // probability that is worth a word

struct Accepted {
  std::vector<Candidate> list;  ///< what stood for choice, best first
};

/// Change that the evaluator's present base made against earlier predictions: the largest, over noise, of any
/// channel in any run.
double largestChange(const Evaluator& evaluator, const std::vector<Prediction>& before) {
  double most = 0;
  const Evidence& data = evaluator.evidence();
  for (std::size_t t = 0; t < before.size(); ++t)
    for (std::size_t s = 0; s < before[t].values.size(); ++s) {
      const auto &a = before[t].values[s], &b = evaluator.basePrediction(t).values[s];
      const auto& weights = data.weights(t, s);
      double sum = 0, n = 0;
      for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
        if (weights[k] <= 0 || !std::isfinite(a[k]) || !std::isfinite(b[k])) continue;
        sum += weights[k] * (a[k] - b[k]) * (a[k] - b[k]);
        ++n;
      }
      if (n > 0) most = std::max(most, std::sqrt(sum / n));
    }
  return most;
}

/// Whether a gain on the blocks for judging is no accident of a few of them: large against its own scatter
/// over blocks, absolutely or in shares of each block, or, where little moves in most, nearly all in one
/// direction.
bool consistent(const Fit& before, const Fit& after) {
  double sum = 0, squares = 0, sizes = 0, share = 0, shareSquares = 0;
  for (std::size_t b = 0; b < before.squares.size(); ++b) {
    if (Evidence::forFitting(b)) continue;
    const double d = before.squares[b] - after.squares[b], whole = before.squares[b] + after.squares[b];
    const double part = whole > 0 ? d / whole : 0;
    sum += d;
    squares += d * d;
    sizes += std::abs(d);
    share += part;
    shareSquares += part * part;
  }
  return sum > 0 && (sum >= leastZ * std::sqrt(squares) || share >= leastZ * std::sqrt(shareSquares) ||
                     sum >= oneWay * sizes);
}

bool severalChainsOff(const Evaluator& evaluator) {
  std::set<int> roots;
  const auto& trials = evaluator.evidence().trials();
  for (std::size_t t = 0; t < trials.size(); ++t)
    for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
      const Signal& signal = trials[t].signals[s];
      if (trials[t].freeBase || signal.kind != SignalKind::position || !(evaluator.chi(t, s) > 1.5)) continue;
      const auto chain = evaluator.jointsTouched({nullptr, {Site::joint, signal.joint, ""}, 0, 0});
      roots.insert(chain.front());
    }
  return roots.size() >= 3;
}

/// Every effect is as likely as any other before the data; one whose value can lie on either side of nominal
/// has half of that for each side.
double prior(const Cause& cause) {
  const Effect& e = *cause.effect;
  const double sides = e.lower < e.nominal && e.nominal < e.upper ? 2 : 1, axes = e.hasAxis ? 3 : 1;
  return 1 / (sides * axes);
}

/// What a sum of squares has to differ by for a nat of evidence: samples are correlated, and where two causes
/// come within a thousandth of each other, the engines' own difference may decide.
double temperature(double judging) { return 2 * (correlation + engineShare * judging); }

/// Most probable first.
void sortByProbability(std::vector<Candidate>& list) {
  const auto cost = [](const Candidate& c) {
    return c.fit.judging - 2 * correlation * std::log(prior(c.cause));
  };
  std::stable_sort(list.begin(), list.end(),
                   [&](const Candidate& a, const Candidate& b) { return cost(a) < cost(b); });
}

class Procedure {
public:
  Procedure(Evaluator& fine_, Evaluator& coarse_, const DiagnosisOptions& options_)
      : fine(fine_), coarse(coarse_), options(options_) {}

  Diagnosis run() {
    setBase({});
    nominal = fine.baseFit();
    const WorstGap worst = worstGap(fine);
    result.worstBefore = worst.size;
    result.worstSignal = worst.signal;
    rememberGap();
    grow();
    beginOtherwise();
    if (found.size() > 1) reconsider();
    setBase(found);
    const WorstGap left = worstGap(fine);
    result.worstAfter = left.size;
    result.worstSignalAfter = left.signal;
    judge();
    return result;
  }

private:
  void setBase(const Explanation& causes) {
    fine.setBase(causes);
    coarse.setBase(causes);
  }

  std::vector<Candidate> candidates(const std::string& stage) {
    SearchOptions search_;
    search_.jobs = options.jobs;
    search_.progress = [&](double share) {
      if (options.progress) options.progress(stage, share);
    };
    std::vector<Candidate> list = search(fine, coarse, possibleCauses(fine), search_);
    if (severalChainsOff(fine) &&
        std::ranges::none_of(fine.base(), [](const Cause& c) { return c.effect->id == "command_dropout"; })) {
      LostCycles lost = findLostCycles(fine.mechanism(), fine.evidence(), fine.base());
      if (lost.found > 2) {
        fine.setLostCycles(lost.cycles);
        coarse.setLostCycles(lost.cycles);
        Candidate candidate;
        candidate.cause = {findEffect("command_dropout"), {Site::everywhere, -1, "*"}, lost.share, 0};
        candidate.fit = fine.with(candidate.cause);
        // Each cycle called lost was chosen to fit: it pays for the choice.
        const double price = 14 * static_cast<double>(lost.found) / 2;
        candidate.fit.judging += price;
        list.push_back(std::move(candidate));
      }
    }
    sortByProbability(list);
    return list;
  }

  /// Tries the best candidates on top of the base, all values fitted together; keeps the one that predicts
  /// best of those that earn their place.
  bool accept(const std::vector<Candidate>& list) {
    const Fit before = fine.baseFit();
    const Explanation old = fine.base();
    std::vector<Prediction> predictions;
    for (std::size_t t = 0; t < fine.evidence().trials().size(); ++t)
      predictions.push_back(fine.basePrediction(t));
    const WorstGap worst = worstGap(fine);
    const double excess = before.judging - noiseShare();
    Explanation best;
    double bestJudging = INFINITY;
    const std::size_t tries = old.empty() ? 1 : 3;
    for (std::size_t i = 0; i < std::min(tries, list.size()); ++i) {
      if (list[i].fit.judging > list.front().fit.judging + 0.3 * (before.judging - list.front().fit.judging))
        break;
      Explanation tried = old;
      tried.push_back(list[i].cause);
      if (!old.empty()) tried = fitTogether(fine, tried, 40, options.jobs);
      setBase(tried);
      // It lowers the worst channel, or a good part of the whole: real robots have more than one thing
      // missing.
      const double gain = before.judging - fine.baseFit().judging;
      const bool lowers = worstGap(fine).size < 0.98 * worst.size + 0.02 || gain > leastShare * excess;
      const bool earned = lowers && gain >= leastGain && consistent(before, fine.baseFit()) &&
                          largestChange(fine, predictions) >= visible;
      if (earned && fine.baseFit().judging < bestJudging) {
        best = tried;
        bestJudging = fine.baseFit().judging;
      }
      setBase(old);
    }
    if (best.empty()) return false;
    setBase(best);
    return true;
  }

  /// Sum of squares on the blocks for judging that noise alone would leave.
  double noiseShare() const {
    const Evidence& data = fine.evidence();
    double n = 0;
    for (std::size_t t = 0; t < data.trials().size(); ++t)
      for (std::size_t s = 0; s < data.trials()[t].signals.size(); ++s) {
        if (fine.basePrediction(t).values[s].empty()) continue;
        const auto& weights = data.weights(t, s);
        for (std::size_t k = 0; k < weights.size(); ++k)
          n += weights[k] > 0 && !Evidence::forFitting(data.block(t, k));
      }
    return n;
  }

  /// Adds causes from the base on until none earns its place. first: the candidate to begin with in a list
  /// known already; none: the list is looked for.
  void grow() {
    while (found.size() < options.maxCauses) {
      const double enough =
          found.empty() ? present : std::max(present, unexplainedShare / 2 * result.worstBefore);
      if (worstGap(fine).size < enough) break;
      std::vector<Candidate> list = candidates(found.empty() ? "first cause" : "further cause");
      if (found.empty()) firsts = list;
      if (!accept(list)) break;
      found = fine.base();
      choices.push_back({std::move(list)});
    }
  }

  /// Where much stays unexplained, the first cause may have been the wrong one: begins with others, keeps the
  /// set that predicts best.
  void beginOtherwise() {
    if (firsts.empty() || worstGap(fine).size < std::max(unexplained, unexplainedShare * result.worstBefore))
      return;
    Explanation best = found;
    std::vector<Accepted> bestChoices = choices;
    double bestJudging = fine.baseFit().judging;
    const std::vector<Candidate> list = firsts;
    for (std::size_t i = 1; i < std::min<std::size_t>(list.size(), 4); ++i) {
      if (list[i].fit.judging > nominal.judging - 0.5 * (nominal.judging - list.front().fit.judging)) break;
      found = {list[i].cause};
      choices = {{list}};
      setBase(found);
      grow();
      if (fine.baseFit().judging < bestJudging - leastGain && found.size() > 1) {
        best = found;
        bestChoices = choices;
        bestJudging = fine.baseFit().judging;
      }
    }
    found = best;
    choices = bestChoices;
    setBase(found);
  }

  /// Each cause once more with the others in place: another may do better now, or it may not be needed.
  void reconsider() {
    for (std::size_t i = 0; i < found.size();) {
      Explanation others = found;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      setBase(found);
      const double whole = fine.baseFit().judging;
      setBase(others);
      if (fine.baseFit().judging - whole < leastGain) {
        found = others;
        choices.erase(choices.begin() + static_cast<std::ptrdiff_t>(i));
        continue;
      }
      std::vector<Candidate> list = candidates("each cause again");
      if (!list.empty() && list.front().fit.judging < whole - leastGain &&
          !list.front().cause.sameKind(found[i])) {
        found[i] = list.front().cause;
      }
      choices[i].list = std::move(list);
      ++i;
    }
    if (found.size() > 1) {
      setBase(found);
      found = fitTogether(fine, found, 48, options.jobs);
    }
  }

  /// Signals that show something under the nominal model: the gap is measured on them.
  void rememberGap() {
    const auto& trials = fine.evidence().trials();
    double least = 0.35;
    for (int round = 0; round < 2; ++round, least = -INFINITY) {
      counted.assign(trials.size(), {});
      bool any = false;
      for (std::size_t t = 0; t < trials.size(); ++t)
        for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
          const double chi = fine.chi(t, s);
          counted[t].push_back(Evidence::counts(trials[t].signals[s]) && std::isfinite(chi) &&
                               chi - 1 > least);
          any = any || counted[t].back();
        }
      if (any) break;
    }
    result.gap.before = gapUnder();
  }

  double gapUnder() const {
    const Evidence& data = fine.evidence();
    double sum = 0, n = 0;
    for (std::size_t t = 0; t < data.trials().size(); ++t) {
      const Trial& trial = data.trials()[t];
      for (std::size_t s = 0; s < trial.signals.size(); ++s) {
        const auto& predicted = fine.basePrediction(t).values[s];
        if (!counted[t][s] || predicted.empty()) continue;
        const auto& weights = data.weights(t, s);
        for (std::size_t k = 0; k < trial.cycles(); ++k) {
          if (weights[k] <= 0 || !std::isfinite(predicted[k]) || Evidence::forFitting(data.block(t, k)))
            continue;
          const double r = trial.signals[s].values[k] - predicted[k];
          sum += weights[k] * r * r;
          ++n;
        }
      }
    }
    return n > 0 ? std::sqrt(sum / n) : 0;
  }

  void judge() {
    result.gap.after = gapUnder();
    const double remains = result.worstAfter, was = result.worstBefore;
    const double allowed = std::max(unexplained, unexplainedShare * was);
    result.knownProbability = 1 / (1 + std::exp(6 * (remains / allowed - 1)));
    if (found.empty()) {
      result.verdict = was < unexplained ? Verdict::none : Verdict::unknown;
    } else {
      result.verdict = remains > allowed ? Verdict::unknown : Verdict::effect;
    }
    for (std::size_t i = 0; i < found.size(); ++i) result.findings.push_back(findingOf(i));
    std::stable_sort(result.findings.begin(), result.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.closedLast > b.closedLast; });
    setBase(found);
  }

  Finding findingOf(std::size_t i) {
    Finding finding;
    finding.cause = found[i];
    Explanation others = found;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    fine.setBase(others);
    const double without = gapUnder();
    const Fit fit = fine.with(finding.cause);
    // Curvature of the sum of squares in the share of the cause that is there.
    const double spread = fit.change > 0 ? 1.96 * std::sqrt(correlation / fit.change) : 1;
    const double nominal_ = finding.cause.effect->nominal, distance = finding.cause.value - nominal_;
    finding.lower = nominal_ + distance * (1 - spread);
    finding.upper = nominal_ + distance * (1 + spread);
    if (finding.lower > finding.upper) std::swap(finding.lower, finding.upper);
    fine.setBase({finding.cause});
    const double alone = gapUnder();
    const double whole = std::max(1e-9, result.gap.before - result.gap.floor);
    finding.closedAlone = std::clamp((result.gap.before - alone) / whole, 0.0, 1.0);
    finding.closedLast = std::clamp((without - result.gap.after) / whole, 0.0, 1.0);

    // Weight of each that stood for choice, by how much worse it predicts what it was not fitted to.
    const auto& list = choices[i].list;
    double best = INFINITY, sum = 0;
    for (const Candidate& c : list) best = std::min(best, c.fit.judging);
    const auto weightOf = [&](const Candidate& c) {
      return std::exp(-(c.fit.judging - best) / temperature(best));
    };
    for (const Candidate& c : list) sum += weightOf(c);
    for (const Candidate& c : list) {
      const double probability = result.knownProbability * weightOf(c) / std::max(sum, 1e-300);
      if (c.cause.sameKind(finding.cause)) {
        finding.probability = probability;
      } else if (probability > rivalShare) {
        finding.rivals.push_back({c.cause, probability});
      }
    }
    return finding;
  }

  Evaluator &fine, &coarse;
  const DiagnosisOptions& options;
  Diagnosis result;
  Fit nominal;
  Explanation found;
  std::vector<Accepted> choices;
  std::vector<Candidate> firsts;
  std::vector<std::vector<bool>> counted;
};

}  // namespace

Explanation Diagnosis::explanation() const {
  Explanation causes;
  for (const Finding& finding : findings) causes.push_back(finding.cause);
  return causes;
}

WorstGap worstGap(const Evaluator& evaluator) {
  WorstGap worst;
  const auto& trials = evaluator.evidence().trials();
  for (std::size_t t = 0; t < trials.size(); ++t)
    for (std::size_t s = 0; s < trials[t].signals.size(); ++s) {
      const double chi = evaluator.chi(t, s);
      if (!Evidence::counts(trials[t].signals[s]) || !std::isfinite(chi)) continue;
      const double size = std::sqrt(std::max(0.0, chi - 1));
      if (size > worst.size) worst = {size, trials[t].signals[s].name};
    }
  return worst;
}

Diagnosis diagnose(Evaluator& fine, Evaluator& coarse, const DiagnosisOptions& options) {
  return Procedure(fine, coarse, options).run();
}

}  // namespace plumbline::gap
