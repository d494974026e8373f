#include "Baselines.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "ChainReplay.h"
#include "FitOfEverything.h"
#include "NestedFriction.h"
#include "SingleEffect.h"
#include "framework/WriteFile.h"
#include "gap/diagnosis/CauseSearch.h"
#include "gap/replay/TrialOf.h"
#include "gap/run/RunCheck.h"
#include "gap/run/RunFile.h"

namespace plumbline::bench {

namespace {

namespace fs = std::filesystem;
using namespace gap;
using nlohmann::json;

fs::path placeOf(const std::string& folder, const char* way, const BlindCase& c) {
  return fs::path(folder) / way / (c.name + ".json");
}

void write(const fs::path& place, const Explanation& causes) {
  json j = {{"verdict", causes.empty() ? "none" : "effect"}, {"effects", json::array()}};
  for (const Cause& cause : causes) {
    json e = {{"effect", cause.effect->id}, {"at", cause.place.at}, {"value", cause.value}};
    e["axis"] = cause.place.axis ? json(std::string(1, cause.place.axis)) : json(nullptr);
    j["effects"].push_back(e);
  }
  fs::create_directories(place.parent_path());
  writeFile(place.string(), j.dump(1));
}

std::vector<Trial> trialsOf(const std::string& runs, const Mechanism& robot) {
  std::vector<Trial> trials;
  std::vector<RunWarning> ignored;
  for (const std::string& run : findRuns(runs))
    trials.push_back(trialOf(readCheckedRun(run, robot, ignored), robot));
  return trials;
}

bool imuRecorded(const Evidence& evidence) {
  return std::ranges::any_of(evidence.trials(), [](const Trial& trial) {
    return std::ranges::any_of(trial.signals, [](const Signal& s) {
      return s.kind == SignalKind::gyro || s.kind == SignalKind::accelerometer;
    });
  });
}

}  // namespace

void writeBaselines(const BlindCase& c, const Mechanism& robot, const std::string& runs,
                    const std::string& folder, int jobs) {
  const auto wanted = [&](const BaselineWay& way) {
    return way.id != std::string("largest_rmse") && (!way.libraryOnly || c.inLibrary()) &&
           !fs::exists(placeOf(folder, way.id, c));
  };
  if (std::ranges::none_of(baselineWays, wanted)) return;
  const Evidence evidence(trialsOf(runs, robot));
  Evaluator fine(robot, evidence), coarse(robot, evidence, coarseSteps());
  const ChainReplay chain(coarse, coarseSteps());
  const std::pair<const char*, std::function<Explanation()>> ways[] = {
      {"fit_everything", [&] { return fitOfEverything(robot, chain, imuRecorded(evidence), jobs); }},
      {"nested_friction", [&] { return nestedFriction(robot, chain, jobs); }},
      {"best_bic", [&] { return bestByBic(fine, coarse, jobs); }},
      {"oracle", [&] { return oracle(c, fine, coarse, jobs); }}};
  for (const auto& [id, answer] : ways) {
    const auto* way = std::ranges::find(baselineWays, std::string_view(id), &BaselineWay::id);
    if (wanted(*way)) write(placeOf(folder, id, c), answer());
  }
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
  const fs::path place = placeOf(folder, "largest_rmse", c);
  fs::create_directories(place.parent_path());
  writeFile(place.string(), out.dump(1));
}

}  // namespace plumbline::bench
