// bin/gap check: the share of the gap that an answer closes in recordings that it never saw.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "framework/Parallel.h"
#include "framework/WriteFile.h"
#include "gap/answer/ServoSettings.h"
#include "gap/diagnosis/ExplanationFile.h"
#include "gap/inference/LeftJson.h"
#include "gap/replay/CurrentSide.h"
#include "gap/replay/TrialOf.h"
#include "gap/report/AnswerCauses.h"
#include "gap/report/AnswerFile.h"
#include "gap/report/SettingsInForce.h"
#include "gap/run/RunCheck.h"
#include "gap/run/RunFile.h"
#include "main/gap/ChangesOption.h"
#include "main/gap/Commands.h"
#include "main/gap/RobotOption.h"

namespace plumbline::gap {

namespace {

struct CheckOptions {
  std::string answer, robot, json;
  std::vector<std::string> runs;
  int jobs = 0;
  bool further = false;
  ChangesOption changes;
};

/// The recordings that can be replayed; reports the others.
std::vector<Trial> trialsIn(const CheckOptions& options, Mechanism& robot) {
  std::vector<std::string> folders;
  for (const std::string& path : options.runs)
    for (std::string& folder : findRuns(path)) folders.push_back(std::move(folder));
  std::vector<RunWarning> warnings;
  const std::string name = readRun(folders.front(), warnings).robot;
  robot = robotOf(options.robot, name);
  std::vector<Trial> trials;
  std::string refused;
  const RunChanges changes = options.changes.changes();
  for (const std::string& folder : folders) {
    warnings.clear();
    try {
      const Run run = readCheckedRun(folder, robot, warnings, changes);
      if (run.robot != name)
        throw RunError(folder + ": recorded on the robot '" + run.robot + "', the others on '" + name +
                       "'; check one robot at a time");
      trials.push_back(trialOf(run, robot));
    } catch (const RunError& error) {
      std::fprintf(stderr, "gap: %s; this run is left out\n", error.what());
      refused = error.what();
    }
  }
  if (trials.empty()) throw RunError(refused);
  findCurrentSide(trials);
  return trials;
}

/// The share that an answer claims to close, with its interval; null if it claims nothing.
struct Claimed {
  nlohmann::json closed, interval;
};
Claimed claimedIn(const nlohmann::json& answer, bool further) {
  const auto at = [&](const std::string& path) {
    const nlohmann::json::json_pointer place(path);
    return answer.contains(place) ? answer.at(place) : nlohmann::json();
  };
  if (further) return {at("/gap/further/claimed"), at("/gap/further/claimed_interval")};
  return {at("/gap/closed"), at("/gap/closed_interval")};
}

void check(const CheckOptions& options) {
  const nlohmann::json answer = readAnswer(options.answer);
  Mechanism robot;
  const std::vector<Trial> trials = trialsIn(options, robot);
  const Explanation causes = causesOf(options.further ? furtherSettingsOf(answer, options.answer)
                                                      : replayedSettingsOf(answer, options.answer),
                                      robot);
  std::vector<SettingChoice> choices;
  if (!options.further) choices = settingChoices(answer, options.answer, robot, causes);
  std::vector<RecordingLeft> left(trials.size());
  std::vector<std::vector<SettingSeen>> settings(trials.size());
  parallel(trials.size(), threadsFor(options.jobs), [&](std::size_t i) {
    const Prediction nominal = replay(plantOf(trials[i], {}), trials[i]);
    left[i] = leftIn(trials[i], nominal, {{0, causes}});
    settings[i] = settingsSeen(trials[i], nominal, left[i].after, choices);
  });
  putFloors(trials, left);
  putNoise(trials, left);
  nlohmann::json result = checkJson(left);
  const std::vector<std::string> beyond =
      settingsBeyond(settingsIn(answer.value("servo_settings", nlohmann::json())), trials);
  result["beyond"] = beyond;
  if (!choices.empty()) result["settings"] = nlohmann::json::array();
  std::vector<std::string> unexpected;
  for (const auto& ofTrial : settings)
    for (const SettingSeen& seen : ofTrial) {
      result["settings"].push_back({{"folder", seen.folder},
                                    {"effect", seen.effect},
                                    {"expected", seen.expected},
                                    {"with", seen.with},
                                    {"without", seen.without},
                                    {"nearer", seen.isNearerWith() ? "with" : "without"}});
      if (seen.isUnexpected()) unexpected.push_back(seen.sentence());
    }
  const std::string verdict = answer["verdict"];
  result["verdict"] = verdict;
  const Claimed claimed = claimedIn(answer, options.further);
  result["claimed"] = claimed.closed;
  const nlohmann::json& interval = claimed.interval;
  const bool ranges =
      interval.is_array() && interval.size() == 2 && interval[0].is_number() && interval[1].is_number();
  if (ranges) result["claimed_interval"] = interval;
  if (!options.json.empty() && options.json != "-") writeFile(options.json, result.dump(1) + "\n");
  if (options.json == "-") {
    std::printf("%s\n", result.dump(1).c_str());
    return;
  }
  if (options.further)
    std::printf("The values of all joints are checked, not the causes named.\n");
  else if (verdict == "unknown")
    std::printf("The verdict is unknown; its nearest explanation is checked.\n");
  std::printf("%s", leftTable(left).c_str());
  std::printf("Closed on average %.0f %%", 100 * meanClosedToNoise(left));
  if (claimed.closed.is_number())
    std::printf("; the answer claims %.0f %%", 100 * claimed.closed.get<double>());
  if (ranges)
    std::printf(" (90 %%: %.0f to %.0f %%)", 100 * interval[0].get<double>(),
                100 * interval[1].get<double>());
  std::printf(".\n");
  for (const std::string& line : unexpected) std::printf("%s\n", line.c_str());
  for (const std::string& line : beyond) std::printf("%s: no claim is made about that.\n", line.c_str());
}

}  // namespace

void addCheck(CommandLine& app) {
  auto options = std::make_shared<CheckOptions>();
  CommandLine command =
      app.command("check", "Replays other recordings with the nominal model and with what an answer found");
  command.option("answer", options->answer, "The file that bin/gap diagnose --json wrote").required();
  command.option("run", options->runs, "Run folders, or folders of run folders").required();
  command.option("--robot", options->robot,
                 "URDF with its servo table, or JSON file, or a name in config/robots "
                 "[the robot that the runs name]");
  command.option("--json", options->json, "Write the figures here; - for standard output");
  command.option("--jobs", options->jobs, "Threads [as many as cores]").range(1, 256);
  command.flag("--further", options->further,
               "The values of all joints (gap.further) instead of the causes named");
  options->changes.addTo(command);
  command.footer(
      "Examples:\n  bin/gap check answer.json other_runs --json check.json\n"
      "  bin/gap check answer.json other_runs --further");
  command.whenChosen([options] { check(*options); });
}

}  // namespace plumbline::gap
