#include "gap/inference/LinearSearch.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "gap/inference/Score.h"
#include "gap/inference/StrengthFit.h"

namespace plumbline::gap {

namespace {

constexpr int stepsOfRound = 4, stepsAtEnd = 10;
constexpr std::size_t proposalsPerMove = 10;

class LinearSearch {
public:
  LinearSearch(CoefficientReplayer& replayer, const LinearSearchOptions& options)
      : options_(options), replayer_(replayer), fitter_(replayer, options.configured) {}

  std::vector<SetProposal> run() {
    const StrengthSet start = fitter_.setOf(options_.start);
    lookFrom(start);
    std::set<std::vector<std::size_t>> seen;
    std::vector<std::size_t> kinds = start.kinds;
    for (int round = 0; round < options_.rounds; ++round) {
      report(0.8 * round / options_.rounds);
      const StrengthSet set = fitter_.refine(climb(kinds), stepsOfRound);
      lookFrom(set);
      collect(set.kinds);
      if (!seen.insert(set.kinds).second) break;
      kinds = set.kinds;
    }
    report(0.8);
    return settled();
  }

private:
  void report(double share) const {
    if (options_.progress) options_.progress(share);
  }

  /// Linearises again, about a set.
  void lookFrom(const StrengthSet& set) {
    sharesUpdated_ = replayer_.updateColumnShares(fitter_.causesOf(set));
    linear_.emplace(fitter_.linearise(set, fitter_.all()));
    scored_.clear();
  }

  const SetScore& score(const std::vector<std::size_t>& kinds) {
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

  /// Whether no move takes a kind out: the last ones are those that were configured.
  bool stays(std::size_t kind) const { return kind + options_.configured.size() >= fitter_.kinds().size(); }

  static std::vector<std::size_t> lessOne(std::vector<std::size_t> kinds, std::size_t kind) {
    std::erase(kinds, kind);
    return kinds;
  }

  /// The best set after a single move: add a cause, drop one, or replace one.
  std::vector<std::size_t> moved(const std::vector<std::size_t>& kinds) {
    std::vector<std::size_t> best = kinds;
    const auto look = [&](const std::vector<std::size_t>& other) {
      if (score(other).score() > score(best).score()) best = other;
    };
    const auto lookAtOneMore = [&](const std::vector<std::size_t>& rest) {
      for (const std::size_t kind : linear_->proposals(score(rest).set, proposalsPerMove))
        if (const auto larger = extended(rest, kind)) look(*larger);
    };
    lookAtOneMore(kinds);
    for (const std::size_t kind : kinds) {
      if (stays(kind)) continue;
      look(lessOne(kinds, kind));
      lookAtOneMore(lessOne(kinds, kind));
    }
    return best;
  }

  /// The best set that single moves reach in the linear model.
  StrengthSet climb(std::vector<std::size_t> kinds) {
    for (;;) {
      std::vector<std::size_t> next = moved(kinds);
      if (next == kinds) return score(kinds).set;
      kinds = std::move(next);
    }
  }

  /// Removes the causes of a set one by one, the least useful first, and keeps the best set for each number
  /// of causes.
  void collect(std::vector<std::size_t> kinds) {
    for (;;) {
      const SetScore& scored = score(kinds);
      const auto [known, fresh] = bestBySize_.try_emplace(kinds.size(), scored);
      if (!fresh && (sharesUpdated_ || scored.score() > known->second.score())) known->second = scored;
      if (std::ranges::all_of(kinds, [this](std::size_t kind) { return stays(kind); })) return;
      kinds = bestLessOne(kinds);
    }
  }

  std::vector<std::size_t> bestLessOne(const std::vector<std::size_t>& kinds) {
    std::optional<std::vector<std::size_t>> best;
    for (const std::size_t kind : kinds)
      if (!stays(kind) && (!best || score(lessOne(kinds, kind)).score() > score(*best).score()))
        best = lessOne(kinds, kind);
    return *best;
  }

  /// The best set that was collected, for each number of causes.
  std::vector<SetScore> worthSettling() const {
    std::vector<SetScore> sets;
    for (const auto& [size, scored] : bestBySize_) sets.push_back(scored);
    std::ranges::stable_sort(sets, std::ranges::greater(), &SetScore::score);
    if (sets.size() > options_.mostSettled) sets.resize(options_.mostSettled);
    std::ranges::stable_sort(sets, {}, [](const SetScore& of) { return of.set.kinds.size(); });
    return sets;
  }

  /// Derivatives may say that a cause explains something where the replay with its value shows nothing.
  StrengthSet withoutIdle(StrengthSet set) const {
    if (!options_.idleCauses) return set;
    for (;;) {
      const std::vector<std::size_t> idle = options_.idleCauses(fitter_.causesOf(set));
      if (idle.empty()) return set;
      StrengthSet rest = set;
      for (const std::size_t i : idle) rest = gap::without(rest, set.kinds[i]);
      set = fitter_.refine(std::move(rest), stepsAtEnd);
    }
  }

  /// The same sets, each fitted completely and scored by derivatives at itself.
  std::vector<SetProposal> settled() const {
    std::vector<SetProposal> proposals;
    for (const SetScore& scored : worthSettling()) {
      const StrengthSet set = withoutIdle(fitter_.refine(scored.set, stepsAtEnd));
      const LinearResiduals linear = fitter_.linearise(set, set.kinds);
      SetProposal& proposal = proposals.emplace_back();
      proposal.set = asScored(linear.score(set.kinds));
      for (const std::size_t kind : set.kinds)
        proposal.lessOne.push_back(asScored(linear.score(lessOne(set.kinds, kind))));
    }
    report(1);
    return proposals;
  }

  /// With information in logarithms of strengths, as the free replays' sets have it.
  Scored asScored(const SetScore& of) const {
    Scored scored;
    scored.fitted.causes = fitter_.causesOf(of.set);
    for (const Eigen::MatrixXd& information : of.information) {
      scored.fitted.information.emplace_back(of.set.x.asDiagonal() * information * of.set.x.asDiagonal());
      scored.fitted.gradient.emplace_back(Eigen::VectorXd::Zero(of.set.x.size()));
    }
    for (const Eigen::VectorXd& x : of.without) scored.without.push_back(fitter_.causesOf({of.set.kinds, x}));
    scored.gain = of.density;  // what the nominal model has is the same for all sets of one picture
    scored.price = of.price;
    return scored;
  }

  const LinearSearchOptions& options_;
  CoefficientReplayer& replayer_;
  bool sharesUpdated_ = false;  ///< scores of one round are not those of another
  const StrengthFitter fitter_;
  std::optional<LinearResiduals> linear_;
  std::map<std::vector<std::size_t>, SetScore> scored_;  ///< in the present linear picture
  std::map<std::size_t, SetScore> bestBySize_;
};

}  // namespace

std::vector<SetProposal> proposedSets(CoefficientReplayer& replayer, const LinearSearchOptions& options) {
  return LinearSearch(replayer, options).run();
}

}  // namespace plumbline::gap
