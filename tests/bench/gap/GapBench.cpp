// How well the diagnosis names what is hidden from it: a sealed set made in MuJoCo, each case diagnosed by
// bin/gap in a process that sees the runs alone, scored beside simpler ways. Writes build/bench/gap.json,
// build/bench/gap.md and doc/results/gap.md. Environment:
//   CASES      how many cases [27; 200 for the full set]; with SET its first so many [all]
//   SEED       of the set [1]
//   JOBS       cases at a time [as many as cores]
//   BASELINES  simpler ways answer every n-th case [1]; 0: only the one that costs nothing
//   SET        a folder that `bin/gap blind make` wrote, instead of making one
// A set that is there is taken as it is, and so is each answer in build/bench/gap-answers-*: a run that was
// stopped goes on. After a change of the diagnosis remove that folder.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "Baselines.h"
#include "Page.h"
#include "framework/Parallel.h"
#include "framework/WriteFile.h"
#include "gap/blind/Make.h"
#include "gap/blind/ScoreDetection.h"
#include "robot/MechanismFile.h"
#include "support/Diagnoses.h"
#include "support/Environment.h"

using namespace plumbline;
using namespace plumbline::gap;
using namespace plumbline::bench;
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct Setting {
  std::string cases, answers;  ///< folders
  std::size_t count = 0;       ///< 0: all there are
  std::uint64_t seed = 1, baselines = 1;
  int jobs = 1;
  bool given = false;
};

Setting settingOf() {
  Setting s;
  s.seed = environment("SEED", 1);
  s.baselines = environment("BASELINES", 1);
  s.jobs = static_cast<int>(
      std::clamp<std::uint64_t>(environment("JOBS", std::thread::hardware_concurrency()), 1, 256));
  const char* set = std::getenv("SET");
  s.given = set && *set;
  s.count = environment("CASES", s.given ? 0 : 27);
  const std::string mark = std::to_string(s.seed) + "-" + std::to_string(s.count);
  s.cases =
      s.given ? fs::absolute(fs::path(set) / "").parent_path().string() : "build/bench/gap-cases-" + mark;
  s.answers = "build/bench/gap-answers-" + (s.given ? fs::path(s.cases).filename().string() : mark);
  return s;
}

BlindSet theSet(const Setting& setting) {
  if (!setting.given && !fs::exists(setting.cases)) {
    BlindMakeOptions options;
    options.draw.cases = setting.count;
    options.draw.seed = setting.seed;
    options.output = setting.cases;
    options.jobs = setting.jobs;
    options.progress = [](std::size_t done) { std::printf("made %zu\n", done), std::fflush(stdout); };
    makeBlind(options);
  }
  BlindSet set = readSealed(setting.cases);
  if (setting.count && setting.count < set.cases.size()) set.cases.resize(setting.count);
  return set;
}

BlindSet only(const BlindSet& set, const auto& wanted) {
  BlindSet some = set;
  std::erase_if(some.cases, [&](const BlindCase& c) { return !wanted(c); });
  return some;
}

/// The diagnosis and the simpler ways, on the cases that the dear ones among these were asked.
std::vector<Way> compare(const BenchResult& r, const Setting& setting) {
  const auto answered = [&](const char* way) {
    return [&setting, way](const BlindCase& c) {
      return fs::exists(fs::path(setting.answers) / way / (c.name + ".json"));
    };
  };
  BlindSet asked = only(r.set, answered("best_bic"));
  if (asked.cases.empty()) asked = r.set;
  std::vector<Way> ways = {{"diagnosis", "diagnosis",
                            scoreBlind(asked, readAnswers(asked, setting.answers + "/diagnose"), r.robot)}};
  for (const BaselineWay& way : baselineWays) {
    const BlindSet some = only(asked, answered(way.id));
    if (!some.cases.empty())
      ways.push_back({way.id, way.what,
                      scoreBlind(some, readAnswers(some, setting.answers + "/" + way.id), r.robot),
                      way.placeOnly});
  }
  return ways;
}

json entriesOf(const std::string& prefix, const BlindScore& score, bool own, bool placeOnly) {
  json entries = json::array();
  for (const Figure& f : score.figures) {
    if (f.count == 0 || (placeOnly && f.id != "place")) continue;
    const bool lower = f.id == "false_alarms" || f.id == "missed" || f.id == "false_unknown" ||
                       f.id == "extra" || f.id == "parameter_error" || f.id == "ece";
    json entry = {{"name", "gap." + prefix + f.id},
                  {"value", f.value},
                  {"unit", "1"},
                  {"better", lower ? "lower" : "higher"},
                  {"interval", {f.lower, f.upper}},
                  {"cases", f.count}};
    if (const Target* t = targetOf(f.id); t && own) entry["target"] = t->value;
    entries.push_back(entry);
  }
  return entries;
}

std::string figuresJson(const BenchResult& r) {
  json report = entriesOf("", r.own, true, false);
  for (const Way& way : r.ways)
    if (&way != &r.ways.front())
      for (json& entry : entriesOf(way.id + ".", way.score, false, way.placeOnly)) report.push_back(entry);
  const DetectionLimit limit = detectionLimit(detectionsOf(r.set, r.answers, r.robot, false));
  if (limit.count && std::isfinite(limit.ratio))
    report.push_back({{"name", "gap.severity_at_90_percent"},
                      {"value", limit.ratio},
                      {"unit", "noise"},
                      {"better", "lower"},
                      {"target", leastRatio}});
  if (r.timing.count)
    for (const auto& [name, value] : {std::pair{"mean", r.timing.mean}, std::pair{"p95", r.timing.p95}})
      report.push_back({{"name", std::string("gap.diagnosis_cpu_") + name},
                        {"value", value},
                        {"unit", "s"},
                        {"better", "lower"}});
  return report.dump(1) + "\n";
}

void answerAll(const BenchResult& r, const Setting& setting) {
  const std::string own = setting.answers + "/diagnose";
  fs::create_directories(own);
  std::atomic<std::size_t> done = 0;
  parallel(r.set.cases.size(), setting.jobs, [&](std::size_t i) {
    const BlindCase& c = r.set.cases[i];
    const std::string runs = setting.cases + "/" + c.name, answer = own + "/" + c.name + ".json";
    diagnoseCase(runs, answer);
    if (fs::exists(answer)) writeLargestRmse(c, answer, setting.answers);
    if (setting.baselines && i % setting.baselines == 0) writeBaselines(c, r.robot, runs, setting.answers, 1);
    std::printf("%zu/%zu %s\n", ++done, r.set.cases.size(), c.name.c_str());
    std::fflush(stdout);
  });
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc > 1)
    throw std::runtime_error(std::string(argv[1]) +
                             " is not known: CASES, SEED, JOBS, BASELINES and SET of the environment are");
  const Setting setting = settingOf();
  BenchResult result;
  result.set = theSet(setting);
  result.robot = namedMechanism(result.set.robot);
  answerAll(result, setting);
  const std::string own = setting.answers + "/diagnose";
  result.answers = readAnswers(result.set, own);
  result.own = scoreBlind(result.set, result.answers, result.robot);
  result.ways = compare(result, setting);
  std::vector<double> seconds;
  for (const BlindCase& c : result.set.cases)
    if (const auto s = secondsOf(own + "/" + c.name + ".json")) seconds.push_back(*s);
  result.timing = timingOf(seconds);
  const std::string body = pageBody(result);
  writeFile("build/bench/gap.json", figuresJson(result));
  writeFile("build/bench/gap.md", body);
  writeFile("doc/results/gap.md", "# Diagnosis of what a simulator lacks\n\n" + body);
  std::fputs(scoreTable(result.own).c_str(), stdout);
} catch (const std::exception& error) {
  std::fprintf(stderr, "bench gap: %s\n", error.what());
  return 2;
}
