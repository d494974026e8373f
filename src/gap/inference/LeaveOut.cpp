#include "gap/inference/LeaveOut.h"

#include <map>
#include <optional>
#include <string>

#include "gap/inference/Posterior.h"

namespace plumbline::gap {

std::vector<FoundWithout> findWithoutEach(const SearchTools& tools, const SetSearchOptions& options) {
  std::vector<FoundWithout> found;
  const std::size_t count = tools.replayer.groups().count();
  for (std::size_t g = 0; g < count; ++g) {
    const Groups others = tools.replayer.groups().without(g);
    SetSearchOptions settings = options;
    settings.quick = true;
    settings.width = 1;
    settings.proposals = 3;
    if (options.progress)
      settings.progress = [&](double share) {
        options.progress((static_cast<double>(g) + share) / static_cast<double>(count));
      };
    const Replayer replayer(tools.replayer, others);
    std::optional<WindowReplayer> windows;
    if (tools.windows) windows.emplace(*tools.windows, g);
    std::optional<Replayer> coarse;
    if (tools.coarse) coarse.emplace(*tools.coarse, others);
    BeamResult result =
        searchForSets({replayer, windows ? &*windows : nullptr, coarse ? &*coarse : nullptr}, settings);
    FoundWithout& of = found.emplace_back();
    of.causes = result.sets.front().causes();
    of.probabilities = posterior(result.sets);
    of.sets = std::move(result.sets);
  }
  return found;
}

namespace {

/// causesOf: of a trial, the values for each stretch of it.
template <class CausesOf>
std::vector<RecordingLeft> leftOf(const Groups& groups, CausesOf causesOf) {
  std::map<std::string, std::vector<RecordingLeft>> parts;
  std::vector<std::string> order;
  for (std::size_t t = 0; t < groups.trials().size(); ++t) {
    const Trial& trial = groups.trials()[t];
    if (!parts.contains(trial.recording)) order.push_back(trial.recording);
    parts[trial.recording].push_back(leftIn(trial, causesOf(t)));
  }
  std::vector<RecordingLeft> left;
  for (const std::string& folder : order) left.push_back(together(parts[folder]));
  putFloors(groups.trials(), left);
  putNoise(groups.trials(), left);
  return left;
}

}  // namespace

std::vector<RecordingLeft> leftWithout(const Groups& groups, const std::vector<FoundWithout>& found) {
  return leftOf(groups, [&](std::size_t t) {
    std::vector<From> causes;
    for (std::size_t k = 0; k < groups.trials()[t].cycles(); ++k) {
      const std::size_t group = groups.groupOf(t, k);
      if (k == 0 || group != groups.groupOf(t, k - 1)) causes.push_back({k, found[group].causes});
    }
    return causes;
  });
}

std::vector<RecordingLeft> leftWith(const Groups& groups, const Explanation& causes) {
  return leftOf(groups, [&](std::size_t) { return std::vector<From>{{0, causes}}; });
}

std::vector<std::size_t> groupsOfRecordings(const Groups& groups) {
  std::map<std::string, std::size_t> known;
  std::vector<std::size_t> of;
  for (std::size_t t = 0; t < groups.trials().size(); ++t)
    if (known.emplace(groups.trials()[t].recording, 0).second) of.push_back(groups.groupOf(t, 0));
  return of;
}

}  // namespace plumbline::gap
