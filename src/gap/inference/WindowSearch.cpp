#include "gap/inference/WindowSearch.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "gap/inference/Score.h"
#include "gap/inference/WindowFit.h"

namespace plumbline::gap {

namespace {

constexpr int mostRounds = 8;  // of derivatives taken anew
constexpr int stepsOfRound = 4, stepsAtEnd = 10;
constexpr std::size_t proposalsPerMove = 10, setsKept = 12;

class WindowSearch {
public:
  WindowSearch(const WindowReplayer& replayer, const WindowSearchOptions& options)
      : replayer_(replayer), options_(options), fitter_(replayer) {}

  BeamResult run() {
    linear_.emplace(fitter_.linearise({}, fitter_.all()));
    WindowScore best = score({});
    std::set<std::vector<std::size_t>> seen{{}};
    WindowSet next = climb({});
    for (int round = 0; round < mostRounds; ++round) {
      tell(0.9 * round / mostRounds);
      const WindowSet set = fitter_.refine(next, stepsOfRound);
      const bool fresh = seen.insert(set.kinds).second;
      if (getenv("GAP_DEBUG")) {
        fprintf(stderr, "round %d density %.1f:", round, fitter_.density(set));
        for (const Cause& c : fitter_.causesOf(set)) fprintf(stderr, " %s;", describe(c).c_str());
        fprintf(stderr, "\n");
      }
      lookFrom(set);
      if (getenv("GAP_DEBUG"))
        fprintf(stderr, "score %.1f best %.1f\n", score(set.kinds).score(), best.score());
      if (score(set.kinds).score() > best.score()) best = score(set.kinds);
      if (!fresh) break;
      next = climb(set.kinds);
    }
    return answer(best.set);
  }

private:
  void tell(double share) const {
    if (options_.progress) options_.progress(share);
  }

  /// Takes the linear picture anew beside a set.
  void lookFrom(const WindowSet& set) {
    linear_.emplace(fitter_.linearise(set, fitter_.all()));
    scored_.clear();
  }

  const WindowScore& score(const std::vector<std::size_t>& kinds) {
    const auto known = scored_.find(kinds);
    return known != scored_.end() ? known->second
                                  : scored_.emplace(kinds, linear_->score(kinds)).first->second;
  }

  /// The kinds of a set with one more, if they can be together.
  std::optional<std::vector<std::size_t>> extended(std::vector<std::size_t> kinds, std::size_t kind) const {
    if (kinds.size() >= options_.mostCauses) return std::nullopt;
    for (const std::size_t other : kinds)
      if (other == kind || fitter_.exclude(other, kind)) return std::nullopt;
    kinds.insert(std::ranges::lower_bound(kinds, kind), kind);
    return kinds;
  }

  /// Whether a larger set is better by more than the standard error of that, from group to group (the
  /// one-standard-error rule: Breiman et al., Classification and Regression Trees, 1984).
  static bool pays(const WindowScore& larger, const WindowScore& smaller) {
    const double gain = larger.score() - smaller.score();
    const auto n = static_cast<double>(larger.density.size());
    double mean = 0, squares = 0;
    for (std::size_t g = 0; g < larger.density.size(); ++g)
      mean += (larger.density[g] - smaller.density[g]) / n;
    for (std::size_t g = 0; g < larger.density.size(); ++g)
      squares += std::pow(larger.density[g] - smaller.density[g] - mean, 2);
    static const double k = getenv("GAP_SE") ? atof(getenv("GAP_SE")) : 1;
    return gain > k * std::sqrt(n * squares / (n - 1));
  }

  /// The best set that single moves lead to in the linear picture.
  WindowSet climb(std::vector<std::size_t> kinds) {
    for (;;) {
      const double before = score(kinds).score();
      std::vector<std::size_t> best = kinds;
      const auto look = [&](const std::vector<std::size_t>& other) {
        if (other.size() > kinds.size() && !pays(score(other), score(kinds))) return;
        if (score(other).score() > score(best).score()) best = other;
      };
      const auto lookBeside = [&](const std::vector<std::size_t>& rest) {
        for (const std::size_t kind : linear_->proposals(score(rest).set, proposalsPerMove))
          if (const auto larger = extended(rest, kind)) look(*larger);
      };
      lookBeside(kinds);
      for (const std::size_t kind : kinds) {
        std::vector<std::size_t> rest = kinds;
        std::erase(rest, kind);
        look(rest);
        lookBeside(rest);
      }
      if (!(score(best).score() > before)) return score(kinds).set;
      kinds = best;
    }
  }

  BeamResult answer(WindowSet set) {
    set = fitter_.refine(set, stepsAtEnd);
    lookFrom(set);
    score({});
    // What the fit to the end made useless goes.
    for (bool better = true; better;) {
      better = false;
      const std::vector<std::size_t> kinds = set.kinds;
      for (const std::size_t kind : kinds) {
        std::vector<std::size_t> rest = kinds;
        std::erase(rest, kind);
        if (!pays(score(set.kinds), score(rest))) set = score(rest).set, better = true;
      }
    }
    climb(set.kinds);
    if (getenv("GAP_DEBUG")) {
      fprintf(stderr, "answer score %.1f density %.1f:", score(set.kinds).score(), fitter_.density(set));
      for (const Cause& c : fitter_.causesOf(set)) fprintf(stderr, " %s;", describe(c).c_str());
      fprintf(stderr, "\n");
    }
    BeamResult result;
    result.kinds = fitter_.kinds().size();
    std::vector<const WindowScore*> others;
    for (const auto& [kinds, scored] : scored_)
      if (kinds != set.kinds) others.push_back(&scored);
    std::ranges::stable_sort(others, std::ranges::greater(),
                             [](const WindowScore* of) { return of->score(); });
    if (others.size() > setsKept) others.resize(setsKept);
    result.sets.push_back(asScored(score(set.kinds)));
    for (const WindowScore* other : others) result.sets.push_back(asScored(*other));
    for (const std::size_t kind : set.kinds) {
      std::vector<std::size_t> rest = set.kinds;
      std::erase(rest, kind);
      result.lessOne.push_back(asScored(score(rest)));
    }
    tell(1);
    return result;
  }

  /// With information in logarithms of strengths, as the free replays' sets have it.
  Scored asScored(const WindowScore& of) const {
    Scored scored;
    scored.fitted.causes = fitter_.causesOf(of.set);
    for (const Eigen::MatrixXd& information : of.information) {
      scored.fitted.information.emplace_back(of.set.x.asDiagonal() * information * of.set.x.asDiagonal());
      scored.fitted.gradient.emplace_back(Eigen::VectorXd::Zero(of.set.x.size()));
    }
    for (const Eigen::VectorXd& x : of.without) scored.without.push_back(fitter_.causesOf({of.set.kinds, x}));
    scored.density = of.density;
    scored.price = of.price;
    return scored;
  }

  const WindowReplayer& replayer_;
  const WindowSearchOptions& options_;
  const WindowFitter fitter_;
  std::optional<WindowLinear> linear_;
  std::map<std::vector<std::size_t>, WindowScore> scored_;  ///< in the present linear picture
};

}  // namespace

BeamResult searchInWindows(const WindowReplayer& replayer, const WindowSearchOptions& options) {
  return WindowSearch(replayer, options).run();
}

}  // namespace plumbline::gap
