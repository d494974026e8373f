#include "gap/inference/LeaveOut.h"

#include <map>
#include <optional>
#include <string>

#include "gap/inference/Posterior.h"
#include "gap/inference/SettingMask.h"

namespace plumbline::gap {

namespace {

BeamResult searchWithout(const SearchTools& tools, std::size_t group, const Groups& others,
                         const SetSearchOptions& options) {
  SetSearchOptions settings = quickly(options);
  if (options.progress)
    settings.progress = [&](double share) {
      const auto count = static_cast<double>(tools.replayer.groups().count());
      options.progress((static_cast<double>(group) + share) / count);
    };
  const Replayer replayer(tools.replayer, others);
  std::optional<WindowReplayer> windows;
  if (tools.windows) windows.emplace(*tools.windows, group);
  std::optional<Replayer> coarse;
  if (tools.coarse) coarse.emplace(*tools.coarse, others);
  return searchForSets({replayer, windows ? &*windows : nullptr, coarse ? &*coarse : nullptr}, settings);
}

}  // namespace

std::vector<FoundWithout> findWithoutEach(const SearchTools& tools, const SetSearchOptions& options,
                                          const SearchWithout& run) {
  std::vector<FoundWithout> found;
  for (std::size_t g = 0; g < tools.replayer.groups().count(); ++g) {
    const Groups others = tools.replayer.groups().without(g);
    const auto search = [&] { return searchWithout(tools, g, others, options); };
    BeamResult result = run ? run(g, others.count(), search) : search();
    FoundWithout& of = found.emplace_back();
    of.causes = result.sets.front().causes();
    of.probabilities = posterior(result.sets);
    of.sets = std::move(result.sets);
  }
  return found;
}

namespace {

/// From the residual of each trial.
std::vector<RecordingLeft> perRecording(const Groups& groups, const std::vector<RecordingLeft>& perTrial) {
  std::map<std::string, std::vector<RecordingLeft>> parts;
  std::vector<std::string> order;
  for (const RecordingLeft& part : perTrial) {
    if (!parts.contains(part.folder)) order.push_back(part.folder);
    parts[part.folder].push_back(part);
  }
  std::vector<RecordingLeft> left;
  for (const std::string& folder : order) left.push_back(together(parts[folder]));
  putFloors(groups.trials(), left);
  putNoise(groups.trials(), left);
  return left;
}

}  // namespace

std::vector<RecordingLeft> leftWithout(const Groups& groups, const std::vector<FoundWithout>& found) {
  // Of a recording that was left out it is not known which settings it was made with.
  const auto expected = [&](std::size_t group) {
    return groups.stretchesOfOne()
               ? found[group].causes
               : expectedElsewhere(found[group].causes, recordingsOf(groups.without(group)));
  };
  std::vector<RecordingLeft> perTrial;
  for (std::size_t t = 0; t < groups.trials().size(); ++t) {
    const Trial& trial = groups.trials()[t];
    std::vector<From> causes;
    for (std::size_t k = 0; k < trial.cycles(); ++k) {
      const std::size_t group = groups.groupOf(t, k);
      if (k == 0 || group != groups.groupOf(t, k - 1)) causes.push_back({k, expected(group)});
    }
    perTrial.push_back(leftIn(trial, causes));
  }
  return perRecording(groups, perTrial);
}

std::vector<std::vector<RecordingLeft>> leftWithEach(const Groups& groups,
                                                     const std::vector<Explanation>& sets) {
  std::vector<std::vector<RecordingLeft>> perTrial(sets.size());
  for (const Trial& trial : groups.trials()) {
    const Prediction nominal = replay(plantOf(trial, {}), trial);
    for (std::size_t i = 0; i < sets.size(); ++i)
      perTrial[i].push_back(leftIn(trial, nominal, {{0, sets[i]}}));
  }
  std::vector<std::vector<RecordingLeft>> left;
  for (const std::vector<RecordingLeft>& of : perTrial) left.push_back(perRecording(groups, of));
  return left;
}

std::vector<std::size_t> groupsOfRecordings(const Groups& groups) {
  std::map<std::string, std::size_t> known;
  std::vector<std::size_t> of;
  for (std::size_t t = 0; t < groups.trials().size(); ++t)
    if (known.emplace(groups.trials()[t].recording, 0).second) of.push_back(groups.groupOf(t, 0));
  return of;
}

}  // namespace plumbline::gap
