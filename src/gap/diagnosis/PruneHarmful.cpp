#include "gap/diagnosis/PruneHarmful.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "framework/Parallel.h"
#include "gap/diagnosis/Probability.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t mostRivals = 6;  // tried in a cause's place: each is a replay of all runs

/// The set with another cause in the place of one, or without it.
struct Change {
  std::size_t which = 0;
  const FittedCause* instead = nullptr;  ///< null: taken out
  Fit fit = {};

  Explanation madeTo(Explanation causes) const {
    if (!instead) return without(std::move(causes), which);
    causes[which] = instead->cause;
    return causes;
  }
};

/// replaced: a cause that took another's place may only go.
std::vector<Change> changesOf(const ForwardSelection& selection, const std::vector<std::uint8_t>& replaced) {
  std::vector<Change> changes;
  for (std::size_t i = 0; i < selection.causes.size(); ++i) {
    changes.push_back({.which = i});
    std::size_t rivals = 0;
    for (const FittedCause& choice : selection.choices[i]) {
      const auto same = [&](const Cause& cause) { return cause.sameKind(choice.cause); };
      if (replaced[i] || rivals == mostRivals || std::ranges::any_of(selection.causes, same)) continue;
      changes.push_back({.which = i, .instead = &choice});
      ++rivals;
    }
  }
  return changes;
}

/// What was tried in a cause's place, as it fits all runs, most probable first.
std::vector<FittedCause> triedInPlace(const std::vector<Change>& changes, std::size_t which) {
  std::vector<FittedCause> list;
  for (const Change& change : changes) {
    if (change.which != which || !change.instead) continue;
    list.push_back(*change.instead);
    list.back().fit = change.fit;
  }
  sortByProbability(list);
  return list;
}

}  // namespace

bool pruneHarmful(ForwardSelection& selection, Evaluator& fine, const GapMeter& meter, double before,
                  int jobs) {
  bool changed = false;
  std::vector<std::uint8_t> replaced(selection.causes.size());
  fine.setBase(selection.causes);
  while (!selection.causes.empty() && meter.under(fine) > before) {
    std::vector<Change> changes = changesOf(selection, replaced);
    parallel(changes.size(), jobs,
             [&](std::size_t i) { changes[i].fit = fine.of(changes[i].madeTo(selection.causes)); });
    const Change best = *std::ranges::min_element(changes, {}, [](const Change& c) { return c.fit.judging; });
    const auto at = static_cast<std::ptrdiff_t>(best.which);
    selection.causes = best.madeTo(selection.causes);
    if (best.instead) {
      selection.choices[best.which] = triedInPlace(changes, best.which);
      replaced[best.which] = 1;
    } else {
      selection.choices.erase(selection.choices.begin() + at);
      replaced.erase(replaced.begin() + at);
    }
    fine.setBase(selection.causes);
    changed = true;
  }
  return changed;
}

}  // namespace plumbline::gap
