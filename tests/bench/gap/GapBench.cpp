// How well the diagnosis names what is hidden from it: a sealed set made in MuJoCo, each case diagnosed by
// bin/gap in a process that sees the runs alone, scored beside simpler ways. Writes build/bench/gap.json and
// doc/results/gap.md. Environment: CASES (27), SEED (1), BASELINES (1; 0: only those that cost nothing).
// Resumes: a set that is there is taken as it is, and so is each answer.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "Baselines.h"
#include "framework/WriteFile.h"
#include "gap/blind/Make.h"
#include "gap/blind/Score.h"
#include "robot/MechanismFile.h"
#include "simspark/ChildProcess.h"

using namespace plumbline;
using namespace plumbline::gap;
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct Target {
  const char* id;
  double value;
  bool higher;
};
constexpr Target targets[] = {{"top1", .95, true},
                              {"top3", .99, true},
                              {"false_alarms", .02, false},
                              {"unknown_found", .85, true},
                              {"false_unknown", .05, false},
                              {"mixture_f1", .85, true},
                              {"parameter_error", .1, false},
                              {"gap_closed", .9, true},
                              {"ece", .05, false}};

const Target* targetOf(const std::string& id) {
  for (const Target& t : targets)
    if (id == t.id) return &t;
  return nullptr;
}

std::uint64_t environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text && *text ? std::strtoull(text, nullptr, 10) : otherwise;
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", x);
  return text;
}

std::string cell(const Figure& f) {
  if (f.count == 0) return "-";
  return number(f.value) + " [" + number(f.lower) + ", " + number(f.upper) + "]";
}

/// CPU time of one diagnosis [s], or nothing where its answer is there already.
double diagnoseCase(const std::string& runs, const std::string& answer, int jobs) {
  simspark::ChildProcess child(
      {"bin/gap", "diagnose", runs, "--json", answer, "--quiet", "--jobs", std::to_string(jobs)},
      "/dev/null");
  while (child.running()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  if (child.exitStatus() != 0)
    std::fprintf(stderr, "%s: bin/gap diagnose ended with %d\n", runs.c_str(),
                 child.exitStatus().value_or(-1));
  return child.usage().cpuSeconds;
}

BlindSet only(const BlindSet& set, bool (*wanted)(const BlindCase&)) {
  BlindSet some = set;
  std::erase_if(some.cases, [&](const BlindCase& c) { return !wanted(c); });
  return some;
}

struct Way {
  std::string id, what;
  BlindScore score;
  bool placeOnly = false;
};

void writePage(const BlindSet& set, const std::vector<Way>& ways, const std::vector<BlindAnswer>& answers,
               double cpuSeconds, std::size_t timed) {
  const BlindScore& own = ways.front().score;
  const std::time_t now = std::time(nullptr);
  char date[32];
  std::strftime(date, sizeof date, "%Y-%m-%d", std::gmtime(&now));
  std::string text = "# Diagnosis of what a simulator lacks\n\nWritten by `make bench-gap` on " +
                     std::string(date) + " (" + processor() + ", " +
                     std::to_string(std::thread::hardware_concurrency()) +
                     " cores): " + std::to_string(set.cases.size()) + " cases, seed " +
                     std::to_string(set.seed) + ", " + set.robot + " simulated in MuJoCo, " +
                     (set.battery == "hang" ? "hung up, five runs" : "hung up and standing") +
                     " per case. The diagnosis runs as a process of its own on a folder without the answer.";
  if (timed) text += " CPU time per diagnosis: " + number(cpuSeconds / static_cast<double>(timed)) + " s.";
  text +=
      "\n\nIntervals are of 95 %: Wilson's for shares, bootstrap for the rest. Figures are on cases with a "
      "gap of 3 times the noise or more, and on those without an effect.\n\n"
      "| | value and interval | cases | target | met |\n|---|---|---|---|---|\n";
  for (const Figure& f : own.figures) {
    const Target* t = targetOf(f.id);
    const bool met = t && (t->higher ? f.value >= t->value : f.value <= t->value);
    text += "| " + f.what + " | " + cell(f) + " | " + std::to_string(f.count) + " | " +
            (t ? (t->higher ? ">= " : "<= ") + number(t->value) : "") + " | " +
            (t && f.count ? (met ? "yes" : "no") : "") + " |\n";
  }
  if (set.cases.size() < 200)
    text +=
        "\n" + std::to_string(set.cases.size()) +
        " cases are few: the intervals say how little they prove. `CASES=200 make bench-gap` makes the full "
        "set.\n";
  text +=
      "\n## By severity\n\nEffect and place first, singles, by the gap over the noise in the channel that "
      "shows it best:\n\n| gap over noise | share and interval | cases |\n|---|---|---|\n";
  for (const Figure& f : own.bySeverity)
    text += "| " + f.what + " | " + cell(f) + " | " + std::to_string(f.count) + " |\n";
  if (ways.size() > 1) {
    text +=
        "\n## Beside simpler ways\n\nOn the same cases; a place alone names no effect, and the oracle is "
        "asked only where the library has the effect.\n\n| |";
    for (const Way& way : ways) text += " " + way.what + " |";
    text += "\n|---|";
    for (std::size_t i = 0; i < ways.size(); ++i) text += "---|";
    for (const char* id :
         {"top1", "place", "hard", "false_alarms", "unknown_found", "mixture_f1", "parameter_error"}) {
      text += "\n| " + own.figure(id).what + " |";
      for (const Way& way : ways)
        text += " " + (way.placeOnly && std::string(id) != "place" ? "-" : cell(way.score.figure(id))) + " |";
    }
    text += "\n";
  }
  text += "\n## Every case\n\n| case | kind | hidden | gap over noise | answer |\n|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < set.cases.size(); ++i) {
    const BlindCase& c = set.cases[i];
    std::string hidden, said = answers[i].verdict.empty() ? "no answer" : answers[i].verdict;
    const auto name = [](const std::string& effect, const std::string& at, const std::string& axis,
                         double v) {
      char value[32];
      std::snprintf(value, sizeof value, "%.3g", v);
      return effect + " at " + (at == "*" ? "all joints" : at) + (axis.empty() ? "" : " " + axis) + " " +
             value;
    };
    for (const BlindEffect& e : c.effects)
      hidden += (hidden.empty() ? "" : ", ") + name(e.effect, e.at, e.axis, e.value);
    if (answers[i].verdict == "effect") {
      said.clear();
      for (const auto& e : answers[i].effects)
        said += (said.empty() ? "" : ", ") + name(e.effect, e.at, e.axis, e.value) + " (" +
                number(e.probability) + ")";
    }
    text += "| " + c.name + " | " + nameOf(c.kind) + " | " + hidden + " | " + number(c.ratio) + " | " + said +
            " |\n";
  }

  text +=
      "\n## Limits\n\n"
      "- The reality is a simulated one. Its servo, friction and gear are written apart from those that "
      "explain, in another engine with other steps, but by the same project and after the same law.\n"
      "- Sizes are drawn from ranges and then made so that the gap lies between 3 and 100 times the noise "
      "(12 for pairs that look alike); where a place shows less, it is kept with its ratio and counts in "
      "the table by severity only. Of a mixture the ratio is the weaker effect's.\n"
      "- An axis is part of the place. A verdict of unknown names nothing, even where its nearest "
      "explanation is right.\n"
      "- Where all runs hang, effects of ground, feet and external forces are not drawn.\n";
  writeFile("doc/results/gap.md", text);
}

}  // namespace

int main() try {
  const auto count = environment("CASES", 27), seed = environment("SEED", 1);
  const int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const std::string mark = std::to_string(seed) + "-" + std::to_string(count);
  const std::string cases = "build/bench/gap-cases-" + mark,
                    answersFolder = "build/bench/gap-answers-" + mark;
  if (!fs::exists(cases)) {
    BlindMakeOptions options;
    options.draw.cases = count;
    options.draw.seed = seed;
    options.output = cases;
    options.jobs = jobs;
    options.progress = [](std::size_t done) { std::printf("made %zu\n", done), std::fflush(stdout); };
    makeBlind(options);
  }
  const BlindSet set = readSealed(cases);
  const Mechanism robot = findMechanism(set.robot);
  const std::string own = answersFolder + "/diagnose";
  fs::create_directories(own);
  double cpuSeconds = 0;
  std::size_t timed = 0;
  for (const BlindCase& c : set.cases) {
    const std::string answer = own + "/" + c.name + ".json";
    if (!fs::exists(answer)) cpuSeconds += diagnoseCase(cases + "/" + c.name, answer, jobs), ++timed;
    if (fs::exists(answer)) bench::writeLargestRmse(c, answer, answersFolder);
    if (environment("BASELINES", 1) && !fs::exists(answersFolder + "/best_bic/" + c.name + ".json"))
      bench::writeBaselines(c, robot, cases + "/" + c.name, answersFolder, jobs);
    std::printf("diagnosed %s\n", c.name.c_str());
    std::fflush(stdout);
  }
  const std::vector<BlindAnswer> answers = readAnswers(set, own);
  std::vector<Way> ways = {{"diagnosis", "diagnosis", scoreBlind(set, answers, robot)}};
  for (const auto& [id, what] :
       {std::pair{"largest_rmse", "largest joint RMSE"}, std::pair{"best_bic", "best single effect by BIC"},
        std::pair{"oracle", "oracle that knows the effect"}}) {
    const std::string folder = answersFolder + "/" + id;
    if (!fs::exists(folder)) continue;
    const std::string way = id;
    const BlindSet asked =
        way == "oracle" ? only(set, [](const BlindCase& c) { return c.inLibrary(); }) : set;
    ways.push_back({way, what, scoreBlind(asked, readAnswers(asked, folder), robot), way == "largest_rmse"});
  }
  json report = json::array();
  for (const Way& way : ways)
    for (const Figure& f : way.score.figures) {
      if (f.count == 0 || (way.placeOnly && f.id != "place")) continue;
      const bool lower = f.id == "false_alarms" || f.id == "missed" || f.id == "false_unknown" ||
                         f.id == "parameter_error" || f.id == "ece";
      json entry = {{"name", "gap." + (way.id == "diagnosis" ? "" : way.id + ".") + f.id},
                    {"value", f.value},
                    {"unit", "1"},
                    {"better", lower ? "lower" : "higher"},
                    {"interval", {f.lower, f.upper}},
                    {"cases", f.count}};
      if (const Target* t = targetOf(f.id); t && way.id == "diagnosis") entry["target"] = t->value;
      report.push_back(entry);
    }
  writeFile("build/bench/gap.json", report.dump(1) + "\n");
  writePage(set, ways, answers, cpuSeconds, timed);
  std::fputs(scoreTable(ways.front().score).c_str(), stdout);
} catch (const std::exception& error) {
  std::fprintf(stderr, "bench gap: %s\n", error.what());
  return 2;
}
