#include "gap/inference/Beam.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "gap/inference/Strengths.h"
#include "gap/inference/Visible.h"

namespace plumbline::gap {

namespace {

/// Key of a set, independent of values and order.
std::string nameOfSet(const Explanation& causes) {
  std::vector<std::string> names;
  for (const Cause& cause : causes) {
    std::string& name = names.emplace_back(std::string(cause.effect->id) + "@" + cause.place.at +
                                           cause.place.axis + "/" + std::to_string(cause.variant) +
                                           (cause.effect->strengthOf(cause.value) < 0 ? "-" : "+"));
    for (const std::string& recording : cause.inactiveIn) name += "!" + recording;
  }
  std::ranges::sort(names);
  std::string all;
  for (const std::string& name : names) all += name + " ";
  return all;
}

class Search {
public:
  Search(const Replayer& replayer, const BeamOptions& options)
      : replayer_(replayer),
        options_(options),
        shares_(sharesOf(replayer_.groups(), replayer_.residuals({}))),
        own_(options_.screening
                 ? nullptr
                 : std::make_unique<CandidateScreening>(
                       replayer_, shares_, ScreeningOptions{[this](double share) { report(0.3 * share); }})),
        screening_(options_.screening ? *options_.screening : *own_) {}

  BeamResult run() {
    add({});
    for (std::size_t size = 0; size < options_.mostCauses; ++size) {
      report(0.3 + 0.6 * static_cast<double>(size) / static_cast<double>(options_.mostCauses));
      const std::string before = nameOfSet(best().causes());
      for (const Scored& set : top(options_.width)) extend(set.causes(), options_.proposals);
      if (nameOfSet(best().causes()) == before) break;
      improve();
      shares_ = sharesOf(replayer_.groups(), replayer_.residuals(best().causes()));
    }
    improve();
    report(0.9);
    constexpr std::size_t kept = 13;  // sets that probabilities are shared among
    return {top(kept), {}, screening_.numKinds()};
  }

private:
  void report(double share) const {
    if (options_.progress) options_.progress(share);
  }

  void add(const Explanation& causes) {
    if (causes.size() > options_.mostCauses) return;
    std::string name = nameOfSet(causes);
    if (scored_.contains(name)) return;
    Scored set = score(replayer_, shares_, causes, screening_.numKinds(), options_.fitSteps);
    // If the fit removed a cause, the set is the one without it.
    if (std::ranges::any_of(set.causes(),
                            [&](const Cause& cause) { return doesNothing(replayer_.mechanism(), cause); }))
      return;
    if (!scored_.empty() && set.score() > best().score())
      for (std::size_t i = 0; i < set.causes().size(); ++i)
        if (!isVisible(replayer_, set.causes(), i)) return;
    scored_.emplace(std::move(name), std::move(set));
  }

  std::vector<Scored> top(std::size_t most) const {
    std::vector<Scored> sets;
    for (const auto& [name, set] : scored_) sets.push_back(set);
    std::ranges::stable_sort(sets, std::ranges::greater(), &Scored::score);
    if (sets.size() > most) sets.resize(most);
    return sets;
  }
  Scored best() const { return top(1).front(); }

  /// Causes that may pay if added to the base: those that gain half of their price to first order.
  std::vector<Proposal> worthTrying(const Explanation& base, std::size_t most) const {
    std::vector<Proposal> proposals = screening_.propose(replayer_, base, shares_, most);
    const double price = priceOf(1, screening_.numKinds());
    std::erase_if(proposals, [&](const Proposal& proposal) { return proposal.gain < price / 2; });
    return proposals;
  }

  /// Adds causes to a set, in the order of predicted gain. Predictions from the nominal model are too small,
  /// by about the same factor for all causes. A set that could not be the best with twice the corrected gain
  /// is not fitted.
  void extend(const Explanation& base, std::size_t most) {
    constexpr double spread = 2, atLeast = 2;
    double factor = atLeast;
    const auto scoreOf = [&](const Explanation& causes) -> std::optional<double> {
      const auto known = scored_.find(nameOfSet(causes));
      return known == scored_.end() ? std::nullopt : std::optional(known->second.score());
    };
    const std::optional<double> before = scoreOf(base);
    for (const Proposal& proposal : worthTrying(base, most)) {
      if (before && *before + spread * factor * proposal.gain < best().score()) continue;
      Explanation larger = base;
      larger.push_back(proposal.cause);
      add(larger);
      if (const std::optional<double> after = scoreOf(larger); before && after)
        factor = std::max(factor, (*after - *before) / proposal.gain);
    }
  }

  /// Tries sets one move away until none of them is better.
  void improve() {
    constexpr int mostRounds = 3;
    for (int round = 0; round < mostRounds; ++round) {
      const Explanation causes = best().causes();
      for (std::size_t i = 0; i < causes.size(); ++i) {
        const Explanation rest = without(causes, i);
        add(rest);
        extend(rest, options_.width);
        Explanation otherWay = causes;
        for (int variant = 0; variant < causes[i].effect->numVariants(); ++variant) {
          otherWay[i].variant = variant;
          add(otherWay);
        }
        shared(causes, i);
      }
      if (nameOfSet(best().causes()) == nameOfSet(causes)) return;
    }
  }

  /// Lets all joints share a cause that one or some have.
  void shared(const Explanation& causes, std::size_t i) {
    const Cause& cause = causes[i];
    if (cause.place.site != Site::joint || !cause.effect->ofServo) return;
    for (const Place& place : placesOf(*cause.effect, replayer_.mechanism())) {
      if (place.site != Site::everywhere) continue;
      Explanation other;
      for (const Cause& one : causes)
        if (one.effect != cause.effect) other.push_back(one);
      other.push_back(cause);
      other.back().place = place;
      add(other);
    }
  }

  const Replayer& replayer_;
  const BeamOptions& options_;
  Shares shares_;
  const std::unique_ptr<const CandidateScreening> own_;
  const CandidateScreening& screening_;
  std::map<std::string, Scored> scored_;
};

}  // namespace

BeamResult searchSets(const Replayer& replayer, const BeamOptions& options) {
  BeamResult result = Search(replayer, options).run();
  // The answer is fitted to the end, and each group is left out by a fit of its own. The same is done without
  // each of its causes, because the complete fit can make one useless.
  const Shares shares = sharesOf(replayer.groups(), replayer.residuals(result.sets.front().causes()));
  const auto settled = [&](const Explanation& causes, const std::vector<Explanation>& starts) {
    return score(replayer, shares, causes, result.kinds, options.lastSteps, options.lastLeaveOut, starts);
  };
  Scored best = settled(result.sets.front().causes(), {});
  for (std::size_t i = 0; i < best.causes().size();) {
    std::vector<Explanation> starts;
    for (const Explanation& of : best.without) starts.push_back(without(of, i));
    Scored rest = settled(without(best.causes(), i), starts);
    if (rest.score() >= best.score() || doesNothing(replayer.mechanism(), best.causes()[i]) ||
        !isVisible(replayer, best.causes(), i)) {
      best = std::move(rest);
      result.lessOne.clear();
      i = 0;
    } else {
      result.lessOne.push_back(std::move(rest));
      ++i;
    }
  }
  const std::string name = nameOfSet(best.causes()), tried = nameOfSet(result.sets.front().causes());
  std::erase_if(result.sets, [&](const Scored& set) {
    return nameOfSet(set.causes()) == name || nameOfSet(set.causes()) == tried;
  });
  for (const Scored& rest : result.lessOne)
    for (Scored& set : result.sets)
      if (nameOfSet(set.causes()) == nameOfSet(rest.causes())) set = rest;
  result.sets.insert(result.sets.begin(), std::move(best));
  if (options.progress) options.progress(1);
  return result;
}

}  // namespace plumbline::gap
