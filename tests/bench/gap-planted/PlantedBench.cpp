// Planted truth in recordings of real robots: the recordings stay real, one cause is taken out of the nominal
// model, and the diagnosis must name it. Writes build/bench/gap-planted.json and .md. The recordings are not
// part of the project. Environment:
//   DATA    their folder [../shared/gap/real]
//   SEED    of causes, sizes and signs [1]
//   CASES   per set of recordings [5]
//   MOTIONS of the XL330, which are fitted together [sin_sin up_and_down]
//   GAINS   of it, each a set of recordings [kp100 kp200 kp800]
//   JOBS    threads [1]
// What is named already where nothing is planted is neither credit nor fault. A plant is named where its
// cause is new with the right sign, or its strength moved by the planted one within 25 %. A cause that undoes
// a tenth of the plant's change or less counts as the same. Where the planted model is nearer to reality than
// the nominal one (correlation of -0.5 or less with the gap) nothing is counted.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "framework/WriteFile.h"
#include "gap/blind/Planting.h"
#include "gap/inference/Inference.h"
#include "gap/run/RunCheck.h"
#include "math/Random.h"
#include "robot/MechanismFile.h"
#include "support/Environment.h"

namespace plumbline::bench {
namespace {

using gap::Cause;
using gap::Finding;
using gap::Inference;
using Base = gap::RealRecordings;
using gap::differenceOf, gap::leftOfPlant, gap::planted, gap::residualsOf, gap::sized;
using nlohmann::json;

constexpr double within = 0.25;  // of the planted strength
constexpr double same = 0.1;     // of the change: what a cause in another name may leave
constexpr double cancels = -0.5;

// Of this list, so that the cases of a seed stay the same.
constexpr std::string_view kinds[] = {"servo_gain", "servo_damping", "rotor_inertia", "link_mass",
                                      "com_offset", "joint_offset",  "command_delay"};

/// Ratios add as logarithms.
double sizeOf(const Cause& cause, double value) {
  if (cause.effect->nominal == 1) return std::log(std::max(1e-3, value));
  return value - cause.effect->nominal;
}

const Finding* find(const Inference& inference, const Cause& cause, bool oneMotor) {
  for (const Finding& finding : inference.diagnosis.findings)
    if (finding.cause.effect == cause.effect &&
        (finding.cause.place == cause.place ||
         (oneMotor && finding.cause.place.site != gap::Site::link && cause.place.site != gap::Site::link)))
      return &finding;
  return nullptr;
}

std::string format(const char* form, double value) {
  char text[64];
  std::snprintf(text, sizeof text, form, value);
  return text;
}

struct Verdict {
  bool named = false, first = false, covered = false, valueRight = false;
  double probability = 0;
  std::string as;
  std::vector<const Finding*> wrong;
};

Verdict judge(const Base& base, const Base& with, const Cause& plant, const Inference& before,
              const Inference& after) {
  const bool oneMotor = base.robot.onlyMotor() >= 0;
  Verdict verdict;
  bool earlier = false;  // something else that is new or moved stands before it
  for (const Finding& finding : after.diagnosis.findings) {
    const Finding* old = find(before, finding.cause, oneMotor);
    const double now = sizeOf(finding.cause, finding.cause.value);
    const double moved = now - (old ? sizeOf(old->cause, old->cause.value) : 0);
    const bool own = find(after, plant, oneMotor) == &finding;
    const bool alike = own || (std::abs(moved) > 1e-9 && leftOfPlant(base, with, finding.cause) <= same);
    const double wanted = own ? sizeOf(plant, plant.value) : 0;
    const bool right =
        own ? (!old && moved * wanted > 0) || std::abs(moved - wanted) <= within * std::abs(wanted)
            : alike && !old;
    if (right && !verdict.named) {
      verdict.named = true;
      verdict.first = !earlier;
      verdict.probability = finding.probability;
      verdict.as =
          describe(finding.cause) + format(" [%.3g, ", finding.lower) + format("%.3g]", finding.upper);
      if (own) {
        verdict.valueRight = std::abs(moved - wanted) <= 0.15 * std::abs(wanted);
        const double shift = old ? sizeOf(old->cause, old->cause.value) : 0;
        verdict.covered =
            sizeOf(plant, finding.lower) - shift <= wanted && wanted <= sizeOf(plant, finding.upper) - shift;
      }
    } else if (!old || std::abs(moved) > within * std::abs(now - moved)) {
      earlier = true;
    }
    if (!right && !old && !alike) verdict.wrong.push_back(&finding);
  }
  return verdict;
}

struct Sum {
  int plants = 0, first = 0, named = 0;
  void add(const Verdict& v) { ++plants, first += v.first, named += v.named; }
};

Base baseOf(const std::string& robot, const std::vector<std::string>& folders) {
  const Mechanism model = findMechanism(robot);
  std::vector<gap::Run> runs;
  for (const std::string& folder : folders) {
    std::vector<gap::RunWarning> warnings;
    runs.push_back(gap::readCheckedRun(folder, model, warnings));
  }
  return {model, std::move(runs)};
}

void run() {
  const std::string data = environmentText("DATA", "../shared/gap/real");
  const auto seed = static_cast<int>(environment("SEED", 1)),
             cases = static_cast<int>(environment("CASES", 5));
  if (!std::filesystem::is_directory(data + "/xl330_pendulum"))
    throw std::runtime_error(data + " has no xl330_pendulum: make bench-gap-planted DATA=FOLDER");
  std::filesystem::create_directories("build/bench");  // before the work, not after it
  gap::InferenceOptions options;
  options.jobs = std::max(1, static_cast<int>(environment("JOBS", 1)));
  Random random(static_cast<std::uint64_t>(seed));
  std::ostringstream page;
  page << "Seed " << seed << ", motions " << environmentText("MOTIONS", "sin_sin up_and_down") << ", "
       << cases << " cases each of " << environmentText("GAINS", "kp100 kp200 kp800")
       << "; `--method sets`. The rules are in tests/bench/gap-planted/PlantedBench.cpp. Ratio: what the "
          "plant changes over\n"
          "what the answer without it leaves, root mean square of the positions. As: with its 95 % "
          "interval.\n\n"
          "| recordings | planted | ratio | named | first | p | as | wrong findings (p) "
          "|\n|---|---|---|---|---|---|---|---|\n";
  Sum all, below, twice, four;
  int sure = 0, wrongHalf = 0, wrongSure = 0, covered = 0, valued = 0, own = 0, answers = 0;
  double probability = 0;
  std::istringstream gains(environmentText("GAINS", "kp100 kp200 kp800"));
  for (std::string gain; gains >> gain;) {
    std::vector<std::string> folders;
    std::istringstream motions(environmentText("MOTIONS", "sin_sin up_and_down"));
    for (std::string motion; motions >> motion;)
      folders.push_back(data + "/xl330_pendulum/" + gain + "_" + motion);
    const Base base = baseOf("xl330_pendulum", folders);
    const Inference before = gap::infer(base.robot, base.trials, options);
    const std::vector<double> nominal = residualsOf(base, {});
    const double left = differenceOf(residualsOf(base, before.diagnosis.explanation()),
                                     std::vector<double>(nominal.size(), 0));
    std::printf("%s: %.1f mrad left of %.1f\n", gain.c_str(), 1e3 * left,
                1e3 * differenceOf(nominal, std::vector<double>(nominal.size(), 0)));
    for (const Finding& f : before.diagnosis.findings)
      std::printf("  %s (%.2f)\n", describe(f.cause).c_str(), f.probability);
    std::vector<Cause> plants;
    for (const std::string_view kind : kinds)
      for (const Cause& cause : gap::plantsFor(base, *gap::findEffect(kind))) plants.push_back(cause);
    for (int made = 0, tried = 0; made < cases && tried < 20 * cases; ++tried) {
      Cause cause = plants[static_cast<std::size_t>(random.uniform() * static_cast<double>(plants.size()))];
      const double ratio = std::exp(random.uniform(std::log(1.0), std::log(6.0)));
      cause = sized(base, cause, ratio * left);
      if (cause.value == cause.effect->nominal) continue;
      const Base with = planted(base, cause);
      const std::vector<double> planted = residualsOf(with, {});
      std::vector<double> change = planted;
      double dot = 0, a = 0, b = 0;
      for (std::size_t k = 0; k < change.size(); ++k)
        if (const double d = change[k] - nominal[k]; std::isfinite(d * nominal[k]))
          dot += d * nominal[k], a += d * d, b += nominal[k] * nominal[k];
      if (dot / std::sqrt(a * b) <= cancels) continue;
      if (differenceOf(residualsOf(with, {cause}), nominal) >
          0.05 * std::sqrt(a / static_cast<double>(change.size())))
        continue;
      ++made;
      const Inference after = gap::infer(with.robot, with.trials, options);
      const Verdict verdict = judge(base, with, cause, before, after);
      all.add(verdict);
      (ratio >= 4 ? four : ratio >= 2 ? twice : below).add(verdict);
      ++answers;
      probability += verdict.probability;
      sure += verdict.probability >= 0.5;
      if (verdict.named && find(after, cause, true))
        ++own, covered += verdict.covered, valued += verdict.valueRight;
      std::string wrong;
      for (const Finding* f : verdict.wrong) {
        wrongHalf += f->probability > 0.5;
        wrongSure += f->probability > 0.8;
        wrong += (wrong.empty() ? "" : ", ") + describe(f->cause) + format(" (%.2f)", f->probability);
      }
      const std::string line = "| " + gain + " | " + describe(cause) + format(" | %.1f | ", ratio) +
                               (verdict.named ? "yes" : "no") + " | " + (verdict.first ? "yes" : "no") +
                               format(" | %.2f | ", verdict.probability) + verdict.as + " | " + wrong +
                               " |\n";
      std::printf("%s", line.c_str());
      std::fflush(stdout);
      page << line;
    }
  }
  json figures = json::array();
  const auto figure = [&](const std::string& name, double value, const char* better, json target) {
    json one = {{"name", "gap-planted." + name + ".seed" + std::to_string(seed)},
                {"value", value},
                {"unit", "1"},
                {"better", better}};
    if (!target.is_null()) one["target"] = target;
    figures.push_back(one);
  };
  const auto share = [](int count, int of) { return of ? static_cast<double>(count) / of : 0.0; };
  figure("plants", all.plants, "higher", nullptr);
  figure("first", share(all.first, all.plants), "higher", 0.6);
  figure("first-from-four-times", share(four.first, four.plants), "higher", 0.9);
  figure("first-from-twice", share(twice.first + four.first, twice.plants + four.plants), "higher", 0.7);
  figure("first-below-twice", share(below.first, below.plants), "higher", nullptr);
  figure("named", share(all.named, all.plants), "higher", nullptr);
  figure("probability-of-the-right-one", probability / std::max(1, all.plants), "higher", 0.5);
  figure("right-with-half-or-more", share(sure, all.plants), "higher", nullptr);
  figure("value-within-15-percent-of-named", share(valued, own), "higher", 0.9);
  figure("interval-covers-of-named", share(covered, own), "higher", 0.9);
  figure("wrong-above-0.5-per-answer", share(wrongHalf, answers), "lower", 0);
  figure("wrong-above-0.8-per-answer", share(wrongSure, answers), "lower", 0);
  writeFile("build/bench/gap-planted.md", page.str());
  writeFile("build/bench/gap-planted.json", figures.dump(1) + "\n");
}

}  // namespace
}  // namespace plumbline::bench

int main() try { plumbline::bench::run(); } catch (const std::exception& error) {
  std::fprintf(stderr, "bench gap-planted: %s\n", error.what());
  return 2;
}
