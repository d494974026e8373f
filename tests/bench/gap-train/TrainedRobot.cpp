#include "TrainedRobot.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "framework/ConfigFile.h"
#include "framework/ConfigFolder.h"
#include "framework/Parallel.h"
#include "framework/WriteFile.h"
#include "gap/blind/Bootstrap.h"
#include "gap/blind/Draw.h"
#include "gap/diagnosis/ExplanationFile.h"
#include "gap/record/WalkRecording.h"
#include "gap/report/AnswerCauses.h"
#include "gap/report/AnswerFile.h"
#include "robot/MechanismFile.h"
#include "support/RunProgram.h"

namespace plumbline::bench {

namespace fs = std::filesystem;
using namespace gap;
using training::WalkTrialResult;

namespace {

constexpr const char* robotName = "nao_v5";
constexpr const char* firstSpread = "0.35";  // of a search that begins with a walk that is good already
constexpr int strengths = 4;                 // each twice the one before
// Tries of the walk that decide whether a robot is taken: at most, and after how many each it is asked
// whether they are enough.
constexpr std::uint64_t drawnBy = 100, drawnAtOnce = 20;
constexpr std::uint64_t firstDrawn = 50'000;  // the first of these: other ones than those that measure

/// What the short searches look for: the parameters that speed depends on most.
const std::vector<std::string> searched{
    "speed.maxForward",        "speed.trimForward",    "step.duration",    "step.height",
    "posture.hipHeight",       "posture.torsoPitch",   "model.copForward", "model.copOutward",
    "feedback.anklePitchGain", "feedback.hipPitchGain"};

walking::WalkGaits walkIn(const std::string& folder) {
  const ConfigFile file("walking", {configFolder(), folder});
  walking::WalkGaits gaits = walking::readWalkGaits(file.root());
  file.checkUnknown();
  return gaits;
}

WalkTrialResult meanOf(const std::vector<WalkTrialResult>& tries) {
  WalkTrialResult mean;
  const auto n = static_cast<double>(tries.size());
  for (const WalkTrialResult& t : tries) {
    mean.speed += t.speed / n;
    mean.falls += t.falls / n;
    mean.drift += t.drift / n;
  }
  return mean;
}

Explanation causesOf(const std::vector<BlindEffect>& effects, const Mechanism& robot) {
  Explanation causes;
  for (const BlindEffect& e : effects) {
    const Effect* effect = findEffect(e.effect);
    causes.push_back({effect, findPlace(*effect, robot, e.at, e.axis), e.value, 0});
  }
  return causes;
}

/// Whether a walk can have it and feels it: in legs, torso or all joints.
bool walksOn(const Mechanism& robot, const BlindEffect& e) {
  if (!findEffect(e.effect)->inWalk) return false;
  std::vector<int> legs;
  for (const Mechanism::Foot& foot : robot.feet)
    for (const int joint : robot.chain(foot.link)) legs.push_back(joint);
  if (const int joint = robot.jointIndex(e.at); joint >= 0)
    return std::ranges::find(legs, joint) != legs.end();
  for (std::size_t l = 1; l < robot.links.size(); ++l)
    if (robot.links[l].name == e.at) {
      const std::vector<int> chain = robot.chain(static_cast<int>(l));
      return !chain.empty() && std::ranges::find(legs, chain.front()) != legs.end();
    }
  return true;
}

}  // namespace

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value / static_cast<double>(values.size());
  return sum;
}

TrainBench::TrainBench(const TrainSetup& setup) : setup_(setup), mechanism_(namedMechanism(robotName)) {
  start_ = setup_.folder + "/start";
  train({"", ""}, start_, setup_.startGenerations);
  const std::string folder = setup_.folder + "/nominal";
  train({"", start_}, folder, setup_.generations);
  nominalWalk_ = walkIn(folder);
  onNominal_ = meanOf(measure(nominalWalk_, {}, setup_.measured)).speed;
  onModel_ = meanOf(measureIn("bullet", nominalWalk_, {}, setup_.measured, 0)).speed;
  drawnOnNominal_ = measure(nominalWalk_, {}, drawnBy, firstDrawn);
}

void TrainBench::train(const TrainStart& start, const std::string& output, std::uint64_t generations) const {
  const std::string walk = output + "/walking.yaml";
  if (fs::exists(walk) && !fs::exists(walk + ".search")) return;
  fs::create_directories(output);
  std::vector<std::string> command = {"bin/optimizewalk",
                                      "--robot",
                                      robotName,
                                      "--task",
                                      "forward",
                                      "--generations",
                                      std::to_string(generations),
                                      "--population",
                                      std::to_string(setup_.population),
                                      "--tries",
                                      std::to_string(setup_.tries),
                                      "--seconds",
                                      std::to_string(setup_.seconds),
                                      "--sigma",
                                      firstSpread,
                                      "--seed",
                                      std::to_string(setup_.seed),
                                      "--jobs",
                                      std::to_string(setup_.jobs),
                                      "--output",
                                      walk};
  if (!start.effects.empty()) command.insert(command.end(), {"--effects", start.effects});
  if (!start.from.empty()) command.insert(command.end(), {"--from", start.from});
  command.emplace_back("--only");
  command.insert(command.end(), searched.begin(), searched.end());
  runProgram(command, output + "/log");
}

std::vector<WalkTrialResult> TrainBench::measureIn(const std::string& engine, const walking::WalkGaits& walk,
                                                   const Explanation& effects, std::uint64_t tries,
                                                   std::uint64_t first) const {
  std::vector<WalkTrialResult> results(tries);
  parallel(results.size(), static_cast<int>(setup_.jobs), [&](std::size_t i) {
    const auto robot = walkerWith(engine, mechanism_, walk, effects);
    training::WalkTrialSetup trial;
    // The searches' own seeds are below 100 million.
    trial.seed = 1'000'000'000 + setup_.seed * 100'000 + first + i;
    trial.tries = 1;
    trial.seconds = 6;
    results[i] = training::tryWalk(*robot, walk, training::WalkTrialKind::forward, trial);
  });
  return results;
}

TrainBench::Loss TrainBench::lossWith(const Explanation& effects) const {
  std::vector<double> lost;  // of the same tries, in parts of the nominal speed
  while (lost.size() < drawnBy) {
    const std::size_t first = lost.size();
    const std::vector<WalkTrialResult> with = measure(nominalWalk_, effects, drawnAtOnce, firstDrawn + first);
    for (std::size_t i = 0; i < drawnAtOnce; ++i)
      lost.push_back((drawnOnNominal_[first + i].speed - with[i].speed) / onNominal_);
    const auto [lower, upper] = bootstrapInterval(lost, mean, 2000);
    if (lower > mostLoss) return Loss::tooMuch;
    if (upper < leastLoss) return Loss::tooLittle;
    if (lower >= leastLoss && upper <= mostLoss) return Loss::enough;
  }
  if (mean(lost) > mostLoss) return Loss::tooMuch;
  return bootstrapInterval(lost, mean, 2000).first >= leastLoss ? Loss::enough : Loss::tooLittle;
}

BlindCase TrainBench::draw(std::size_t turn) const {
  const std::string kept = setup_.folder + "/robot" + std::to_string(turn + 1) + "/truth.json";
  if (fs::exists(kept)) {
    std::ifstream file(kept);
    return parseBlindSet({std::istreambuf_iterator<char>(file), {}}).cases.front();
  }
  Random random(setup_.seed * 1000 + turn);
  DrawOptions options;
  options.seed = setup_.seed;
  for (std::size_t at = 11 * turn;; ++at) {
    BlindCase truth;
    truth.name = "robot" + std::to_string(turn + 1);
    truth.kind = turn % 2 == 0 ? BlindKind::single : BlindKind::mixture;
    truth.effects = drawEffects(mechanism_, truth.kind, at, options, random);
    if (!std::ranges::all_of(truth.effects, [&](const BlindEffect& e) { return walksOn(mechanism_, e); }))
      continue;
    for (int strength = 0; strength < strengths; ++strength) {
      const Loss loss = lossWith(causesOf(truth.effects, mechanism_));
      if (loss == Loss::tooMuch) break;
      if (loss == Loss::enough) {
        fs::create_directories(fs::path(kept).parent_path());
        writeFile(kept, blindSetText({robotName, setup_.engine, "all", setup_.seed, {truth}}));
        return truth;
      }
      for (BlindEffect& effect : truth.effects) effect = strengthened(mechanism_, effect, 2);
    }
  }
}

void TrainBench::record(const std::string& folder) const {
  if (fs::exists(folder + "/runs")) return;
  runProgram(
      {"bin/gap", "record", "--robot", robotName, "--engine", setup_.engine, "--battery", "all", "--seed",
       std::to_string(setup_.seed), "--effects", folder + "/truth.yaml", "-o", folder + "/runs"},
      folder + "/log");
}

TrainedRobot TrainBench::robot(std::size_t turn) const {
  TrainedRobot result;
  result.truth = draw(turn);
  const std::string folder = setup_.folder + "/robot" + std::to_string(turn + 1),
                    answerFile = folder + "/answer.json";
  const Explanation truth = causesOf(result.truth.effects, mechanism_);
  writeFile(folder + "/truth.yaml", simulation::effectsText(settingsOf(truth), "In the robot"));
  record(folder);
  if (!fs::exists(answerFile))
    runProgram({"bin/gap", "diagnose", folder + "/runs", "--json", answerFile, "--quiet", "--jobs",
                std::to_string(setup_.jobs)},
               folder + "/log");
  const nlohmann::json answer = readAnswer(answerFile);
  result.verdict = answer["verdict"];
  Explanation found;
  for (const Cause& cause : gap::causesOf(answer, answerFile, mechanism_).causes)
    if (cause.effect->inWalk) found.push_back(cause);
  for (const Cause& cause : found)
    result.found.push_back({std::string(cause.effect->id),
                            cause.place.at,
                            cause.place.axis ? std::string(1, cause.place.axis) : "",
                            cause.value,
                            {}});
  std::string effects;
  if (!found.empty()) {
    effects = folder + "/found.yaml";
    writeFile(effects, simulation::effectsText(settingsOf(found), "Found by bin/gap diagnose"));
  }
  // Where nothing was found the search is the one without, and so is what it finds.
  walking::WalkGaits walk = nominalWalk_;
  if (!found.empty()) {
    train({effects, start_}, folder + "/walk", setup_.generations);
    walk = walkIn(folder + "/walk");
  }
  const std::vector<WalkTrialResult> without = measure(nominalWalk_, truth, setup_.measured),
                                     with = measure(walk, truth, setup_.measured);
  for (std::size_t i = 0; i < with.size(); ++i)
    result.differences.push_back(with[i].speed - without[i].speed);
  result.without = meanOf(without);
  result.with = meanOf(with);
  return result;
}

}  // namespace plumbline::bench
