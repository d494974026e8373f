#include "gap/settings/SettingsDiagnosis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "gap/settings/SettingsEvaluator.h"
#include "math/Random.h"
#include "optimization/Brent.h"

namespace plumbline::gap {

namespace {

using Part = SettingsEvaluator::Part;

constexpr int looks = 9;                  // values over a setting's range that are looked at
constexpr std::size_t refined = 4;        // settings whose value is fitted
constexpr double leastZ = 3;              // of the gain over left-out windows
constexpr double minSameSignShare = 0.5;  // of the gains' absolute values over left-out recordings
constexpr double leastGain = 0.02;        // mean gain per left-out window [nat]
constexpr double leastShare = 0.02;       // of what the score has to lose
constexpr double rivalShare = 0.01;
constexpr int resamples = 2000;

/// A setting with its fitted value on top of a base.
struct SettingCandidate {
  SettingValue value;
  std::vector<double> gains;     ///< per left-out recording
  double gain = 0, squares = 0;  ///< sums of gains and of their squares over left-out windows
};

std::vector<SettingValue> without(std::vector<SettingValue> values, std::size_t i) {
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(i));
  return values;
}

class SettingsProcedure {
public:
  SettingsProcedure(const TraceEvidence& evidence, const SimulatorSetup& nominal,
                    const SettingsOptions& options)
      : evidence_(evidence),
        nominal_(nominal),
        options_(options),
        evaluator_(evidence, nominal, options.jobs) {}

  SettingsDiagnosis run() {
    const SetupFit bare = evaluator_.of(nominal_, Part::all);
    result_.gap.before = evaluator_.gap(bare.errors);
    grow();
    if (found_.size() > 1) reconsider();
    const SetupFit end = evaluator_.of(with(nominal_, found_), Part::all);
    const std::vector<WindowError> own = evidence_.ownErrors(with(nominal_, found_), options_.jobs);
    result_.gap.after = evaluator_.gap(end.errors);
    result_.gap.floor = evaluator_.gap(own);
    judge();
    for (std::size_t i = 0; i < found_.size(); ++i) result_.findings.push_back(findingOf(i));
    std::ranges::stable_sort(result_.findings, std::ranges::greater(), &SettingFinding::closedLast);
    result_.cells = cellsOf(bare.errors, end.errors, own);
    result_.nextMotion = nextMotion();
    result_.windows = evidence_.windows().size();
    result_.leftOutWindows =
        static_cast<std::size_t>(std::ranges::count(evidence_.windows(), true, &TraceWindow::leftOut));
    return result_;
  }

private:
  void report(const std::string& stage, double share) const {
    if (options_.progress) options_.progress(stage, share);
  }

  double scoreOf(const std::vector<SettingValue>& base, const SettingValue& value, Part part,
                 int type = -1) const {
    std::vector<SettingValue> all = base;
    all.push_back(value);
    return evaluator_.sum(evaluator_.of(with(nominal_, all), part, type));
  }

  /// Value with the lowest score on the windows for fitting, on a logarithmic scale, from a start and values
  /// a factor away on, within the setting's range.
  SettingValue fitted(const std::vector<SettingValue>& base, const SettingValue& start, double factor,
                      int type = -1) const {
    constexpr int follow = 3, within = 5;
    constexpr double tolerance = 0.005;
    const Setting& s = *start.setting;
    SettingValue best = start;
    double least = std::numeric_limits<double>::infinity();
    const auto score = [&](double logValue) {
      const SettingValue value{&s, std::exp(logValue)};
      const double of = scoreOf(base, value, Part::fitting, type);
      if (of < least) least = of, best = value;
      return of;
    };
    const double lower = std::log(s.lower), upper = std::log(s.upper), step = std::log(factor);
    const double x = std::clamp(std::log(start.value), lower + step / 2, upper - step / 2);
    minimizeBrent(
        score,
        bracketFrom(score, std::max(lower, x - step), x, std::min(upper, x + step), lower, upper, follow),
        tolerance, within);
    return best;
  }

  static std::vector<double> valuesOf(const Setting& setting) {
    std::vector<double> values;
    if (setting.kind == Setting::Kind::positive) {
      for (int i = 0; i < looks; ++i)
        values.push_back(setting.lower * std::pow(setting.upper / setting.lower, i / (looks - 1.0)));
    } else {
      for (int i = 0; setting.lower + i <= setting.upper; ++i) values.push_back(setting.lower + i);
    }
    return values;
  }

  /// Every setting that is not in the base, best on left-out recordings first.
  std::vector<SettingCandidate> search(const std::vector<SettingValue>& base, const std::string& stage) {
    const SimulatorSetup start = with(nominal_, base);
    const double none = evaluator_.sum(evaluator_.of(start, Part::look));
    struct Look {
      const Setting* setting;
      std::vector<double> values;
      std::size_t best;
      double score;
    };
    std::vector<Look> list;
    std::size_t done = 0;
    for (const Setting& setting : settings()) {
      report(stage, 0.7 * static_cast<double>(done++) / static_cast<double>(settings().size()));
      if (std::ranges::any_of(base, [&](const SettingValue& v) { return v.setting == &setting; })) continue;
      Look look{&setting, valuesOf(setting), 0, std::numeric_limits<double>::infinity()};
      for (std::size_t i = 0; i < look.values.size(); ++i) {
        if (look.values[i] == setting.get(start)) continue;
        const double score = scoreOf(base, {&setting, look.values[i]}, Part::look);
        if (score < look.score) look.best = i, look.score = score;
      }
      // A value between two that were looked at may do better than what is there: near misses are fitted too.
      if (look.score < 1.1 * none + 1) list.push_back(std::move(look));
    }
    std::ranges::stable_sort(list, std::ranges::less(), &Look::score);
    if (list.size() > refined) list.resize(refined);
    const SetupFit left = evaluator_.of(start, Part::leftOut);
    std::vector<SettingCandidate> candidates;
    for (const Look& look : list) {
      report(stage, 0.7 + 0.3 * static_cast<double>(candidates.size()) / static_cast<double>(list.size()));
      SettingCandidate c;
      c.value = {look.setting, look.values[look.best]};
      if (look.setting->kind == Setting::Kind::positive)
        c.value = fitted(base, c.value, look.values[1] / look.values[0]);
      std::vector<SettingValue> all = base;
      all.push_back(c.value);
      const SetupFit fit = evaluator_.of(with(nominal_, all), Part::leftOut);
      c.gains = evaluator_.gains(left, fit);
      for (std::size_t w = 0; w < fit.scores.size(); ++w)
        if (evidence_.windows()[w].leftOut) c.squares += std::pow(left.scores[w] - fit.scores[w], 2);
      c.gain = std::accumulate(c.gains.begin(), c.gains.end(), 0.0);
      candidates.push_back(std::move(c));
    }
    std::ranges::stable_sort(candidates, std::ranges::greater(), &SettingCandidate::gain);
    return candidates;
  }

  /// Large against its scatter over windows, mostly one way over recordings, and worth a word.
  bool earns(const SettingCandidate& c, double score) const {
    double sizes = 0;
    for (const double gain : c.gains) sizes += std::abs(gain);
    const auto windows =
        static_cast<double>(std::ranges::count(evidence_.windows(), true, &TraceWindow::leftOut));
    return c.gain >= leastZ * std::sqrt(c.squares) && c.gain >= minSameSignShare * sizes &&
           c.gain >= leastGain * windows && c.gain >= leastShare * score;
  }

  double leftOutScore(const std::vector<SettingValue>& base) const {
    return evaluator_.sum(evaluator_.of(with(nominal_, base), Part::leftOut));
  }

  /// Each value once more about where it is.
  void refine(std::vector<SettingValue>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i].setting->kind != Setting::Kind::positive) continue;
      values[i] = fitted(without(values, i), values[i], 1.5);
    }
  }

  void grow() {
    while (found_.size() < options_.maxSettings) {
      std::vector<SettingCandidate> list =
          search(found_, found_.empty() ? "first setting" : "further setting");
      if (list.empty() || !earns(list.front(), leftOutScore(found_))) break;
      found_.push_back(list.front().value);
      if (found_.size() > 1) refine(found_);
      choices_.push_back(std::move(list));
    }
  }

  /// Each once more with the others in place: another may do better now, or none may be needed.
  void reconsider() {
    for (std::size_t i = 0; i < found_.size();) {
      const std::vector<SettingValue> others = without(found_, i);
      std::vector<SettingCandidate> list = search(others, "each setting again");
      if (list.empty() || !earns(list.front(), leftOutScore(others))) {
        found_ = others;
        choices_.erase(choices_.begin() + static_cast<std::ptrdiff_t>(i));
        continue;
      }
      found_[i] = list.front().value;
      choices_[i] = std::move(list);
      ++i;
    }
    refine(found_);
  }

  void judge() {
    const GapSize& gap = result_.gap;
    const double allowed = std::max(1.3 * gap.floor, gap.floor + 0.2 * (gap.before - gap.floor));
    result_.knownProbability = 1 / (1 + std::exp(12 * (gap.after / allowed - 1)));
    if (found_.empty())
      result_.verdict = gap.before <= 1.3 * gap.floor ? Verdict::none : Verdict::unknown;
    else
      result_.verdict = gap.after <= allowed ? Verdict::effect : Verdict::unknown;
  }

  /// Share of resampled sets of left-out recordings in which each candidate gains most.
  std::vector<double> shares(const std::vector<SettingCandidate>& list) const {
    std::vector<double> wins(list.size());
    if (list.empty()) return wins;
    Random random(options_.seed);
    const std::size_t n = list.front().gains.size();
    for (int r = 0; r < resamples; ++r) {
      std::vector<double> sums(list.size());
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t drawn =
            std::min(n - 1, static_cast<std::size_t>(random.uniform() * static_cast<double>(n)));
        for (std::size_t c = 0; c < list.size(); ++c) sums[c] += list[c].gains[drawn];
      }
      wins[static_cast<std::size_t>(std::max_element(sums.begin(), sums.end()) - sums.begin())] +=
          1.0 / resamples;
    }
    const double most = (static_cast<double>(n) + 1) / (static_cast<double>(n) + 2);
    for (double& share : wins) share = std::min(most, share) * result_.knownProbability;
    return wins;
  }

  SettingFinding findingOf(std::size_t i) {
    SettingFinding finding;
    finding.value = found_[i];
    finding.nominal = found_[i].setting->get(nominal_);
    const std::vector<SettingValue> others = without(found_, i);
    const double whole = std::max(1e-9, result_.gap.before - result_.gap.floor);
    const auto gapOf = [&](const std::vector<SettingValue>& values) {
      return evaluator_.gap(evaluator_.of(with(nominal_, values), Part::leftOut).errors);
    };
    finding.closedAlone = std::clamp((result_.gap.before - gapOf({found_[i]})) / whole, 0.0, 1.0);
    finding.closedLast = std::clamp((gapOf(others) - result_.gap.after) / whole, 0.0, 1.0);
    finding.lower = finding.upper = found_[i].value;
    if (found_[i].setting->kind == Setting::Kind::positive) {
      std::set<int> types;
      for (std::size_t t = 0; t < evidence_.traces().size(); ++t)
        if (!evidence_.leftOut(t)) types.insert(evidence_.traces()[t].robotType.value_or(0));
      for (const int type : types) {
        const double v = fitted(others, finding.value, 2, type).value;
        finding.lower = std::min(finding.lower, v);
        finding.upper = std::max(finding.upper, v);
      }
    }
    const std::vector<double> probability = shares(choices_[i]);
    for (std::size_t c = 0; c < probability.size(); ++c) {
      if (choices_[i][c].value.setting == found_[i].setting)
        finding.probability = probability[c];
      else if (probability[c] > rivalShare)
        finding.rivals.push_back({choices_[i][c].value, probability[c]});
    }
    std::ranges::stable_sort(finding.rivals, std::ranges::greater(), &SettingRival::probability);
    return finding;
  }

  static std::string motionOf(const std::string& trace) { return trace.substr(0, trace.find_last_of('_')); }

  std::vector<SettingCell> cellsOf(const std::vector<WindowError>& before,
                                   const std::vector<WindowError>& after,
                                   const std::vector<WindowError>& own) const {
    std::map<std::string, std::array<std::vector<WindowError>, 3>> motions;
    for (std::size_t w = 0; w < before.size(); ++w) {
      auto& [a, b, c] = motions[motionOf(evidence_.traces()[evidence_.windows()[w].trace].name)];
      a.push_back(before[w]);
      b.push_back(after[w]);
      c.push_back(own[w]);
    }
    std::vector<SettingCell> cells;
    double whole = 0;
    for (const auto& [motion, errors] : motions) {
      const WindowError gap = typicalError(errors[0]), left = typicalError(errors[1]),
                        floor = typicalError(errors[2]);
      for (std::size_t s = 0; s < numTraceSignals; ++s) {
        const auto signal = static_cast<TraceSignal>(s);
        const double unit = evaluator_.unit()[s];
        const double excess = std::max(0.0, (gap[s] * gap[s] - floor[s] * floor[s]) / (unit * unit)) *
                              static_cast<double>(errors[0].size());
        cells.push_back({nameOf(signal), motion, unitOf(signal), gap[s], floor[s], left[s], excess});
        whole += excess;
      }
    }
    for (SettingCell& cell : cells) cell.share = whole > 0 ? cell.share / whole : 0;
    std::ranges::stable_sort(cells, std::ranges::greater(), &SettingCell::share);
    return cells;
  }

  /// The left-out recording in which the leading explanations differ most.
  std::string nextMotion() const {
    for (std::size_t i = 0; i < found_.size(); ++i) {
      const auto& list = choices_[i];
      const auto it = std::ranges::find_if(
          result_.findings, [&](const SettingFinding& f) { return f.value.setting == found_[i].setting; });
      if (it == result_.findings.end() || it->rivals.empty()) continue;
      const Setting* rival = it->rivals.front().value.setting;
      const auto gainsOf = [&](const Setting* setting) -> const std::vector<double>& {
        return std::ranges::find_if(list,
                                    [&](const SettingCandidate& c) { return c.value.setting == setting; })
            ->gains;
      };
      const auto &a = gainsOf(found_[i].setting), &b = gainsOf(rival);
      std::size_t k = 0, most = 0;
      std::string best;
      std::size_t last = std::numeric_limits<std::size_t>::max();
      for (const TraceWindow& window : evidence_.windows()) {
        if (!window.leftOut || window.trace == last) continue;
        last = window.trace;
        if (best.empty() || std::abs(a[k] - b[k]) > std::abs(a[most] - b[most])) {
          most = k;
          best = motionOf(evidence_.traces()[window.trace].name);
        }
        ++k;
      }
      return std::string(found_[i].setting->id) + " and " + std::string(rival->id) +
             " differ most in motions like " + best + ": record more of them, on other robot types.";
    }
    switch (result_.verdict) {
      case Verdict::none:
        return "Nothing is needed for these motions; impacts, falls and kicks into the joints' stops would "
               "show more.";
      case Verdict::unknown:
        return "No setting of this simulator explains the remaining gap; record single parts of the motion "
               "with the largest gap (" +
               (result_.cells.empty() ? std::string() : result_.cells.front().motion) +
               ") slowly, to see whether contacts or hinges are behind it.";
      case Verdict::effect:
        break;
    }
    return "To make the values more certain: the same motions on further robot types.";
  }

  const TraceEvidence& evidence_;
  const SimulatorSetup& nominal_;
  const SettingsOptions& options_;
  SettingsEvaluator evaluator_;
  SettingsDiagnosis result_;
  std::vector<SettingValue> found_;
  std::vector<std::vector<SettingCandidate>> choices_;
};

}  // namespace

SettingsDiagnosis diagnoseSettings(const TraceEvidence& evidence, const SimulatorSetup& nominal,
                                   const SettingsOptions& options) {
  return SettingsProcedure(evidence, nominal, options).run();
}

}  // namespace plumbline::gap
