// A NAO that walks closed loop in Bullet with one thing in it that the nominal model lacks: is it named from
// three walks of 12 s alone? Effects, places and sizes are drawn as those of sealed sets, among those that
// walks in Bullet can have; every fourth robot has none. Environment: CASES [16], SEED [1], JOBS at a time.
// Walks and answers in build/bench/gap-walk-SEED/ are kept: a bench that was stopped goes on; remove the
// folder after a change of the diagnosis. Writes build/bench/gap-walk.json and .md.
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "framework/Parallel.h"
#include "framework/WriteFile.h"
#include "gap/blind/CaseText.h"
#include "gap/blind/Draw.h"
#include "gap/blind/Make.h"
#include "gap/blind/ScoreJudge.h"
#include "gap/diagnosis/Evidence.h"
#include "gap/diagnosis/Explanation.h"
#include "gap/effects/Effects.h"
#include "gap/record/EngineRecording.h"
#include "gap/replay/Replay.h"
#include "gap/replay/TrialOf.h"
#include "gap/run/RunFile.h"
#include "robot/MechanismFile.h"
#include "simspark/ChildProcess.h"
#include "support/Diagnoses.h"
#include "support/Environment.h"
#include "support/FigureJson.h"

using namespace plumbline;
using namespace plumbline::gap;
using namespace plumbline::bench;
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::array walks{"walk_forward", "walk_sideways", "walk_turn"};
constexpr int weaker = 3;  // times a robot that falls is tried with half as much

std::string effectsText(const BlindCase& c) {
  std::string text = "effects:\n";
  for (const BlindEffect& e : c.effects) {
    char value[32];
    std::snprintf(value, sizeof value, "%.9g", e.value);
    text += "  - {effect: " + e.effect + ", at: \"" + e.at + "\", " +
            (e.axis.empty() ? "" : "axis: " + e.axis + ", ") + "value: " + value + "}\n";
  }
  return text;
}

/// One robot: its walks are recorded, then an answer is asked of a process that sees those alone.
class Case {
public:
  Case(const Mechanism& robot, std::string folder, std::size_t turn, std::uint64_t seed)
      : robot_(robot),
        folder_(std::move(folder)),
        name_("case" + std::to_string(turn + 1)),
        noise_(seed * 1000 + turn),
        at_(7 * turn),
        random_(noise_) {
    if (turn % 4 == 0) return;
    truth.kind = BlindKind::single;
    draw_.seed = seed;
    draw_.battery = Battery::all;
  }

  void run() {
    findWalks();
    const std::string answer = folder_ + "/answers/" + truth.name + ".json";
    diagnoseCase(folder_ + "/" + truth.name, answer);
    if (!fs::exists(answer)) throw std::runtime_error(truth.name + " has no answer");
    cpu = secondsOf(answer).value_or(0);
    given = readAnswers({"", "", "", 0, {truth}}, folder_ + "/answers").front();
    text = json::parse(std::ifstream(answer));
  }

  BlindCase truth;
  BlindAnswer given;
  json text;
  double cpu = 0;

private:
  /// The turn walks through all effects: those that a walk cannot have are passed over.
  void drawNext() {
    do truth.effects = drawEffects(robot_, BlindKind::single, at_++, draw_, random_);
    while (!findEffect(truth.effects.front().effect)->inWalk);
  }

  /// Draws and records until a robot walks and what is in it shows. Each attempt keeps its folder.
  void findWalks() {
    for (int attempts = 0;;) {
      if (truth.kind == BlindKind::single) drawNext();
      for (int strength = 0; strength <= weaker; ++strength) {
        if (strength > 0) truth.effects[0] = strengthened(robot_, truth.effects[0], 0.5);
        truth.name = name_ + "-" + std::to_string(++attempts);
        if (!walked()) continue;
        truth.ratio = severity();
        if (truth.kind == BlindKind::none || truth.ratio >= leastRatio) return;
        break;
      }
    }
  }

  bool walked() const {
    const std::string runs = folder_ + "/" + truth.name, effects = runs + ".yaml";
    if (std::ranges::all_of(walks, [&](const char* walk) { return fs::exists(fs::path(runs) / walk); }))
      return true;
    fs::remove_all(runs);
    std::vector<std::string> command = {"bin/gap", "record", "--seed",   std::to_string(noise_),
                                        "-o",      runs,     "--program"};
    command.insert(command.end(), walks.begin(), walks.end());
    // Of nothing a robot would always walk the same way: a millionth of a kilogram leads its steps elsewhere.
    BlindCase played = truth;
    if (played.effects.empty())
      played.effects = {{"link_mass", "Head", "", 1e-9 * static_cast<double>(noise_), {}}};
    writeFile(effects, effectsText(played));
    command.insert(command.end(), {"--effects", effects});
    simspark::ChildProcess child(command, "/dev/null");
    while (child.running()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return child.exitStatus() == 0;
  }

  /// What the effect changes in replays of the walks, over noise, in the channel that shows it best.
  double severity() const {
    std::vector<Trial> trials;
    std::vector<RunWarning> warnings;
    for (const char* walk : walks)
      trials.push_back(trialOf(readRun((fs::path(folder_) / truth.name / walk).string(), warnings), robot_));
    const Evidence evidence(trials);
    Explanation causes;
    for (const BlindEffect& e : truth.effects) {
      const Effect* effect = findEffect(e.effect);
      causes.push_back({effect, findPlace(*effect, robot_, e.at, e.axis), e.value, 0});
    }
    double most = 0;
    for (std::size_t t = 0; t < trials.size(); ++t)
      most = std::max(most, evidence.difference(t, replay(plantOf(trials[t], {}), trials[t]),
                                                replay(plantOf(trials[t], causes), trials[t])));
    return most;
  }

  const Mechanism& robot_;
  const std::string folder_, name_;
  const std::uint64_t noise_;
  std::size_t at_;  ///< where the next draw begins
  Random random_;
  DrawOptions draw_;
};

json figure(const std::string& name, double value, const char* unit, const char* better) {
  return figureJson("gap-walk." + name, value, unit, better);
}

void write(const std::vector<Case>& cases, const Mechanism& robot, std::uint64_t seed) {
  const BlindJudge judge(robot);
  std::size_t singles = 0, first = 0, three = 0, none = 0, alarms = 0;
  std::vector<double> closed;
  double cpu = 0;
  std::string rows;
  for (const Case& c : cases) {
    cpu += c.cpu / static_cast<double>(cases.size());
    std::string named;
    for (const auto& e : c.given.effects)
      named += (named.empty() ? "" : ", ") + nameOfOne(e.effect, e.at, e.axis, e.value);
    const bool right = judge.right(c.truth, c.given);
    if (c.truth.effects.empty()) {
      ++none;
      alarms += c.given.verdict != "none";
    } else {
      ++singles;
      first += judge.first(c.truth, c.given);
      three += judge.amongThree(c.truth, c.given);
      closed.push_back(std::clamp(c.given.closed.value_or(0), 0.0, 1.0));
    }
    char numbers[96];
    char severity[32] = "";
    if (!c.truth.effects.empty()) std::snprintf(severity, sizeof severity, "%.1f", c.truth.ratio);
    std::snprintf(numbers, sizeof numbers, "%.2f to %.2f | %.0f", c.text["gap"]["before"].get<double>(),
                  c.text["gap"]["after"].get<double>(), c.cpu);
    rows += "| " + hidden(c.truth) + " | " + severity + " | " + c.given.verdict + " | " + named + " | " +
            (right ? "yes" : "no") + " | " + numbers + " |\n";
  }
  double mean = 0;
  for (const double share : closed) mean += share / static_cast<double>(closed.size());
  const Figure f = share("", "", first, singles), t = share("", "", three, singles),
               a = share("", "", alarms, none);
  char text[2400];
  std::snprintf(
      text, sizeof text,
      "A NAO walks in Bullet with the project's own walk, forward, sideways and turning, 12 s each; "
      "`bin/gap diagnose` sees these three runs and nothing else. %zu robots, seed %llu.\n\n"
      "Named first: %zu of %zu (95 %%: %.2f to %.2f), among three %zu (%.2f to %.2f). False alarms: "
      "%zu of %zu (up to %.2f). Gap closed on half-seconds left out: %.2f on average; %.0f s of CPU on "
      "average. Severity: the change that the effect makes in replays of these walks, divided by the noise, "
      "in the channel that shows it best; if it is less than 3, the effect is drawn again. The head of a "
      "robot without an effect is about a millionth of a kilogram heavier, with another value for each "
      "robot, so that "
      "no two walk alike. Seed 1 is not blind: the difference that counts as the engines' own (decision 6) "
      "was chosen with walks without any effect and with robots of that seed.\n\n"
      "| in the robot | severity | verdict | named | first right | gap, times the noise | CPU s |\n"
      "|---|---|---|---|---|---|---|\n",
      cases.size(), static_cast<unsigned long long>(seed), first, singles, f.lower, f.upper, three, t.lower,
      t.upper, alarms, none, a.upper, mean, cpu);
  writeFile("build/bench/gap-walk.md", text + rows);
  const json figures = {figure("first", f.value, "1", "higher"),
                        figure("among_three", t.value, "1", "higher"),
                        figure("false_alarms", a.value, "1", "lower"), figure("closed", mean, "1", "higher"),
                        figure("diagnosis_cpu_mean", cpu, "s", "lower")};
  writeFile("build/bench/gap-walk.json", figures.dump(1) + "\n");
}

}  // namespace

int main() try {
  const std::uint64_t seed = environment("SEED", 1);
  const auto count = std::clamp<std::uint64_t>(environment("CASES", 16), 2, 1000);
  const int jobs = static_cast<int>(
      std::clamp<std::uint64_t>(environment("JOBS", std::thread::hardware_concurrency()), 1, 256));
  const Mechanism robot = namedMechanism("nao_v5");
  const std::string folder = "build/bench/gap-walk-" + std::to_string(seed);
  fs::create_directories(folder + "/answers");
  std::vector<Case> cases;
  for (std::size_t i = 0; i < count; ++i) cases.emplace_back(robot, folder, i, seed);
  std::atomic<std::size_t> done = 0;
  parallel(cases.size(), jobs, [&](std::size_t i) {
    cases[i].run();
    std::printf("%zu/%zu %s\n", ++done, cases.size(), cases[i].truth.name.c_str());
    std::fflush(stdout);
  });
  write(cases, robot, seed);
} catch (const std::exception& error) {
  std::fprintf(stderr, "bench gap-walk: %s\n", error.what());
  return 2;
}
