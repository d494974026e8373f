#include "Baselines.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "framework/WriteFile.h"
#include "gap/diagnosis/PossibleCauses.h"
#include "gap/diagnosis/Search.h"
#include "gap/replay/TrialOf.h"
#include "gap/run/RunCheck.h"
#include "gap/run/RunFile.h"

namespace plumbline::bench {

namespace {

using namespace gap;
using nlohmann::json;

void write(const std::string& folder, const char* way, const std::string& name, const Explanation& causes) {
  json j = {{"verdict", causes.empty() ? "none" : "effect"}, {"effects", json::array()}};
  for (const Cause& cause : causes) {
    json e = {{"effect", cause.effect->id}, {"at", cause.place.at}, {"value", cause.value}};
    e["axis"] = cause.place.axis ? json(std::string(1, cause.place.axis)) : json(nullptr);
    j["effects"].push_back(e);
  }
  const std::filesystem::path place = std::filesystem::path(folder) / way;
  std::filesystem::create_directories(place);
  writeFile((place / (name + ".json")).string(), j.dump(1));
}

}  // namespace

void writeBaselines(const BlindCase& c, const Mechanism& robot, const std::string& runs,
                    const std::string& folder, int jobs) {
  std::vector<Trial> trials;
  std::vector<RunWarning> ignored;
  for (const std::string& run : findRuns(runs))
    trials.push_back(trialOf(readCheckedRun(run, robot, ignored), robot));
  const Evidence evidence(std::move(trials));
  Evaluator fine(robot, evidence);
  ReplayOptions coarseSteps;
  coarseSteps.step = 0.005;
  coarseSteps.gearStep = 0.0025;
  Evaluator coarse(robot, evidence, coarseSteps);
  SearchOptions options;
  options.jobs = jobs;
  fine.setBase({});
  coarse.setBase({});
  const std::vector<Cause> all = possibleCauses(fine);

  Explanation best;
  double samples = 0;
  for (std::size_t t = 0; t < evidence.trials().size(); ++t)
    for (std::size_t s = 0; s < evidence.trials()[t].signals.size(); ++s)
      samples +=
          static_cast<double>(std::ranges::count_if(evidence.weights(t, s), [](double w) { return w > 0; }));
  double least = fine.baseFit().fitting - std::log(std::max(2.0, samples / 2));
  for (const Candidate& candidate : search(fine, coarse, all, options))
    if (candidate.fit.fitting < least) least = candidate.fit.fitting, best = {candidate.cause};
  write(folder, "best_bic", c.name, best);

  if (!c.inLibrary()) return;
  Explanation known;
  for (const BlindEffect& truth : c.effects) {
    fine.setBase(known);
    coarse.setBase(known);
    std::vector<Cause> causes = known.empty() ? all : possibleCauses(fine);
    std::erase_if(causes, [&](const Cause& cause) { return cause.effect->id != truth.effect; });
    const std::vector<Candidate> list = search(fine, coarse, causes, options);
    if (!list.empty()) known.push_back(list.front().cause);
  }
  write(folder, "oracle", c.name, known);
}

void writeLargestRmse(const BlindCase& c, const std::string& answer, const std::string& folder) {
  std::ifstream file(answer);
  const json j = json::parse(file);
  std::string joint;
  double most = -1;
  for (const json& signal : j.at("per_signal")) {
    const std::string name = signal.at("signal");
    if (!name.starts_with("pos.") || !signal.at("before").is_number() || signal["before"] <= most) continue;
    most = signal["before"];
    joint = name.substr(4);
  }
  const json out = {{"verdict", "effect"},
                    {"effects", {{{"effect", "anything"}, {"at", joint}, {"axis", nullptr}, {"value", 0}}}}};
  const std::filesystem::path place = std::filesystem::path(folder) / "largest_rmse";
  std::filesystem::create_directories(place);
  writeFile((place / (c.name + ".json")).string(), out.dump(1));
}

}  // namespace plumbline::bench
