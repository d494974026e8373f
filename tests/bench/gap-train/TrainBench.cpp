// What a diagnosis is worth to the next walk. NAOs in MuJoCo that have one or two things that the model lacks
// are recorded hung up and on their feet and diagnosed by bin/gap. They walk with a walk that
// bin/optimizewalk trained on a model with what was found, and with the one that the same search found on the
// nominal model. Both begin with a walk searched on the nominal model before. Environment:
//   ROBOTS [10], SEED [1], JOBS
//   ENGINE [mujoco] of the robots; walks are searched in Bullet
//   START_GENERATIONS [GENERATIONS] of the search on the nominal model before
//   GENERATIONS [25], POPULATION [12], TRIES [6], SECONDS [6] of each search
//   MEASURED [100] tries of each walk in the end
// What is done is kept in build/bench/gap-train-ENGINE-SEED/: a bench that was stopped goes on. Remove the
// folder after a change of diagnosis or walk. Writes build/bench/gap-train.json and .md.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "TrainedRobot.h"
#include "framework/WriteFile.h"
#include "gap/blind/Bootstrap.h"
#include "gap/blind/CaseText.h"
#include "servo/RobotSimulation.h"
#include "support/Environment.h"
#include "support/FigureJson.h"

using namespace plumbline;
using namespace plumbline::gap;
using namespace plumbline::bench;
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

std::string centimetres(double speed) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", 100 * speed);
  return text;
}

json figure(const std::string& name, double value, const char* unit, const char* better) {
  return figureJson("gap-train." + name, value, unit, better);
}

void write(const std::vector<TrainedRobot>& robots, const TrainSetup& setup, double onNominal,
           double onModel) {
  std::vector<double> without, with, gain, lostWithout, lostWith;
  std::size_t better = 0, worse = 0;
  double lost = 0;
  std::string rows;
  for (const TrainedRobot& r : robots) {
    without.push_back(r.without.speed);
    with.push_back(r.with.speed);
    gain.push_back(r.with.speed - r.without.speed);
    lostWithout.push_back(1 - r.without.speed / onNominal);
    lostWith.push_back(1 - r.with.speed / onNominal);
    lost += onNominal - r.without.speed;
    const auto [lower, upper] = bootstrapInterval(r.differences, mean, 2000);
    better += lower > 0;
    worse += upper < 0;
    std::string named;
    for (const auto& e : r.found)
      named += (named.empty() ? "" : ", ") + nameOfOne(e.effect, e.at, e.axis, e.value);
    char numbers[160];
    std::snprintf(numbers, sizeof numbers, "%s (%.0f %%) | %s (%.0f %%) | %+.1f (%+.1f to %+.1f)",
                  centimetres(r.without.speed).c_str(), 100 * r.without.falls,
                  centimetres(r.with.speed).c_str(), 100 * r.with.falls, 100 * gain.back(), 100 * lower,
                  100 * upper);
    rows += "| " + hidden(r.truth) + " | " + r.verdict + " | " + (named.empty() ? "nothing" : named) + " | " +
            numbers + " |\n";
  }
  const auto [lower, upper] = bootstrapInterval(gain, mean, 2000);
  const auto [lostLow, lostHigh] = bootstrapInterval(lostWithout, mean, 2000);
  const auto [lostWithLow, lostWithHigh] = bootstrapInterval(lostWith, mean, 2000);
  const auto number = [](std::uint64_t x) { return std::to_string(x); };
  const bool hasInterval = robots.size() > 2;  // over robots
  const auto range = [&](const char* format, double low, double high) {
    char shown[64] = "";
    if (hasInterval) std::snprintf(shown, sizeof shown, format, 100 * low, 100 * high);
    return std::string(shown);
  };
  const auto percent = [](double x) { return std::to_string(std::lround(100 * x)) + " %"; };
  const std::string text =
      "Robots measured: " + number(robots.size()) + " (seed " + number(setup.seed) +
      "). They are NAOs in the engine " + setup.engine +
      " with one or two effects that the model lacks. The effects are drawn as for "
      "sealed sets and made stronger until the walk trained on the nominal model surely (95 %) loses " +
      percent(leastLoss) + " of its speed, but not " + percent(mostLoss) +
      " (looked at after every 20 of at most 100 tries, each time by a 95 % interval). Each is recorded hung "
      "up and on its feet (`--battery all`, in that engine, with sensor noise) and "
      "diagnosed by "
      "`bin/gap diagnose`, which replays with dynamics of its own. `bin/optimizewalk` then searches in "
      "Bullet "
      "for a forward walk on the model with the effects found (with the nearest explanation if the "
      "verdict is unknown). The walk without is searched as long on the model without these effects. Both "
      "searches begin with the same walk, which one search before them found on the nominal model from the "
      "walk of `config/robots/nao_v5` (" +
      number(setup.startGenerations) + " generations). Each search: " + number(setup.generations) +
      " generations of " + number(setup.population) + ", " + number(setup.tries) + " tries of " +
      number(setup.seconds) + " s. Both walks are tried on the robot itself, " + number(setup.measured) +
      " tries each with seeds that no search used.\n\n"
      "The walk trained without the effects goes " +
      centimetres(onModel) + " cm/s on the nominal robot in Bullet and " + centimetres(onNominal) +
      " cm/s on the nominal robot in " + setup.engine +
      ". On the robots themselves it "
      "loses " +
      percent(mean(lostWithout)) + range(" (95 %%: %.0f to %.0f)", lostLow, lostHigh) +
      " of that; the walks trained with the effects found lose **" + percent(mean(lostWith)) + "**" +
      range(" (95 %%: %.0f to %.0f)", lostWithLow, lostWithHigh) + ". Mean gain " + centimetres(mean(gain)) +
      " cm/s" + range(" (95 %% over robots: %+.1f to %+.1f)", lower, upper) + ", " +
      percent(lost > 0 ? std::accumulate(gain.begin(), gain.end(), 0.0) / lost : 0) +
      " of what was lost. Surely faster: " + number(better) + ", surely slower: " + number(worse) +
      ".\n\n"
      "Speeds are means in cm/s, 0 from a fall on; in brackets the share of tries with a fall, and of the "
      "gain its 95 % "
      "interval (bootstrap over tries).\n\n"
      "| in the robot | verdict | found, and trained with | trained without | trained with | gain |\n"
      "|---|---|---|---|---|---|\n";
  writeFile("build/bench/gap-train.md", text + rows);
  json figures = {figure("robots", static_cast<double>(robots.size()), "1", "higher"),
                  figure("speed_nominal_in_bullet", onModel, "m/s", "higher"),
                  figure("speed_nominal", onNominal, "m/s", "higher"),
                  figure("speed_without", mean(without), "m/s", "higher"),
                  figure("speed_with", mean(with), "m/s", "higher"),
                  figure("lost_without", mean(lostWithout), "1", "lower"),
                  figure("lost_with", mean(lostWith), "1", "lower"),
                  figure("gain", mean(gain), "m/s", "higher"),
                  figure("surely_faster", static_cast<double>(better), "1", "higher"),
                  figure("surely_slower", static_cast<double>(worse), "1", "lower")};
  if (hasInterval) figures.push_back(figure("gain_lower", lower, "m/s", "higher"));
  writeFile("build/bench/gap-train.json", figures.dump(1) + "\n");
}

}  // namespace

int main() try {
  TrainSetup setup;
  setup.seed = environment("SEED", 1);
  const auto count = std::clamp<std::uint64_t>(environment("ROBOTS", 10), 1, 100);
  setup.jobs = std::clamp<std::uint64_t>(environment("JOBS", std::thread::hardware_concurrency()), 1, 256);
  setup.generations = environment("GENERATIONS", 25);
  setup.startGenerations = environment("START_GENERATIONS", setup.generations);
  setup.population = environment("POPULATION", 12);
  setup.tries = environment("TRIES", 6);
  setup.seconds = environment("SECONDS", 6);
  setup.measured = std::clamp<std::uint64_t>(environment("MEASURED", 100), 4, 10000);
  setup.engine = environmentText("ENGINE", "mujoco");
  setup.folder = "build/bench/gap-train-" + setup.engine + "-" + std::to_string(setup.seed);
  fs::create_directories(setup.folder);
  servo::RobotSimulations::require(setup.engine);
  const TrainBench bench(setup);
  std::vector<TrainedRobot> robots;
  for (std::size_t i = 0; i < count; ++i) {
    robots.push_back(bench.robot(i));
    std::printf("%zu/%zu %s: without %.3f, with %.3f m/s\n", i + 1, static_cast<std::size_t>(count),
                hidden(robots.back().truth).c_str(), robots.back().without.speed, robots.back().with.speed);
    std::fflush(stdout);
    write(robots, setup, bench.speedOnNominal(), bench.speedOnModel());
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "bench gap-train: %s\n", error.what());
  return 2;
}
