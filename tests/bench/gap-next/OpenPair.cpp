#include "OpenPair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "framework/WriteFile.h"
#include "gap/blind/Draw.h"
#include "gap/diagnosis/ExplanationFile.h"
#include "gap/inference/CandidateScreening.h"
#include "gap/inference/Fit.h"
#include "gap/record/EngineRecording.h"
#include "gap/record/ExcitationFile.h"
#include "gap/replay/TrialOf.h"
#include "robot/MechanismFile.h"
#include "support/RunProgram.h"

namespace plumbline::bench {

namespace fs = std::filesystem;
using namespace gap;
using nlohmann::json;

namespace {

// Few joints: a screening replays every effect at every place.
constexpr std::array robots{"xl330_pendulum", "tests/e2e/gap/arm.json"};
constexpr std::array programs{"hang_sweep", "hang_multisine", "hang_small", "hang_fast"};
constexpr int weaker = 10;  // times an effect is made weaker
constexpr double weakening = 0.6;
constexpr double visible = 4;  // log odds over nothing at all
constexpr std::size_t screened = 8, mostRivals = 4;
constexpr int fitSteps = 8;

/// A program played on the robot that has the effect, in an engine that explains nothing.
Trial played(const Mechanism& robot, const Excitation& program, const Cause& truth, std::uint64_t seed,
             const std::string& name) {
  SimulatedRecordingOptions options;
  options.effects = {truth};
  options.seed = seed;
  Trial trial = trialOf(recordInEngine("bullet", robot, program, options), robot);
  trial.recording = trial.name = name;
  return trial;
}

/// Explanations beside each other on some recordings.
class Comparison {
public:
  Comparison(const Mechanism& robot, std::vector<Trial> trials, int jobs)
      : groups_(std::move(trials)),
        replayer_(robot, groups_, jobs),
        shares_(sharesOf(groups_, replayer_.residuals({}))) {}

  Fitted fitted(const Cause& start) const { return gap::fit(replayer_, shares_, {start}, fitSteps); }
  /// Under the parts of independent residuals that the better one leaves.
  double logOdds(const Cause& a, const Cause& b) {
    const Fitted first = fitted(a), second = fitted(b);
    shares_ =
        sharesOf(groups_, replayer_.residuals(first.density > second.density ? first.causes : second.causes));
    return densityOf(fitted(first.causes.front()).causes) - densityOf(fitted(second.causes.front()).causes);
  }
  double densityOf(const Explanation& causes) const {
    const std::vector<double> each = densities(groups_, replayer_.residuals(causes), shares_);
    return std::accumulate(each.begin(), each.end(), 0.0);
  }
  std::vector<Proposal> proposals() const {
    return CandidateScreening(replayer_, shares_).propose(replayer_, {}, shares_, screened);
  }

private:
  const Groups groups_;
  const Replayer replayer_;
  gap::Shares shares_;
};

struct Open {
  Cause truth, asFitted, rival;
  double before = 0;
};

/// What one recording leaves open, if it shows the effect and does not decide. rivals: kinds of causes to be
/// tried, found where the effect is as it was drawn.
enum class Shown { nothing, open, decided };
Shown looksLike(const Mechanism& robot, const Trial& trial, Open& open, std::vector<Cause>& rivals,
                int jobs) {
  Comparison comparison(robot, {trial}, jobs);
  const Fitted truth = comparison.fitted(open.truth);
  if (truth.density - comparison.densityOf({}) < visible) return Shown::nothing;
  open.asFitted = truth.causes.front();
  if (rivals.empty())
    for (const Proposal& proposal : comparison.proposals())
      if (proposal.cause.effect != open.truth.effect && rivals.size() < mostRivals)
        rivals.push_back(proposal.cause);
  double most = -HUGE_VAL;
  for (Cause& rival : rivals) {
    const Fitted other = comparison.fitted(rival);
    rival = other.causes.front();
    if (other.density <= most) continue;
    most = other.density;
    open.rival = rival;
  }
  if (rivals.empty()) return Shown::decided;
  open.before = comparison.logOdds(open.asFitted, open.rival);
  return std::abs(open.before) < decided ? Shown::open : Shown::decided;
}

json causeJson(const Cause& cause) {
  json j{{"effect", cause.effect->id}, {"at", cause.place.at}, {"value", cause.value}, {"probability", 0.5}};
  j["axis"] = cause.place.axis ? json(std::string(1, cause.place.axis)) : json(nullptr);
  if (!cause.effect->variants.empty())
    j["variant"] = cause.effect->variants[static_cast<std::size_t>(cause.variant)];
  return j;
}

/// What bin/gap next makes of an answer that leaves the two open.
struct Proposed {
  Excitation motion;
  std::string name;
  bool separates = false;  ///< as it says itself
};
Proposed proposedFor(const Mechanism& robot, const std::string& robotFile, const Open& open,
                     const std::string& folder) {
  json cause = causeJson(open.asFitted);
  cause["confounded_with"] = {causeJson(open.rival)};
  const json answer{{"verdict", "effect"}, {"robot", robot.name}, {"effects", {cause}}};
  writeFile(folder + "/answer.json", answer.dump(1) + "\n");
  fs::remove(folder + "/said");
  runProgram({"bin/gap", "next", folder + "/answer.json", "--robot", robotFile, "-o", folder + "/next.yaml"},
             folder + "/said");
  std::ifstream file(folder + "/said");
  const std::string said{std::istreambuf_iterator<char>(file), {}};
  Proposed proposed;
  proposed.motion = readExcitation(folder + "/next.yaml", robot, 0);
  proposed.name = proposed.motion.about.substr(0, proposed.motion.about.find(':'));
  proposed.separates = said.find("None of these motions separates them") == std::string::npos;
  return proposed;
}

Pair read(const std::string& path) {
  const json j = json::parse(std::ifstream(path));
  return {j["robot"],  j["truth"],        j["rival"],      j["first"], j["proposed"],   j["random"],
          j["before"], j["withProposed"], j["withRandom"], j["draws"], j["inseparable"]};
}

}  // namespace

Pair pairOf(const std::string& folder, std::size_t turn, std::uint64_t seed, int jobs) {
  const std::string own = folder + "/pair" + std::to_string(turn + 1), kept = own + "/pair.json";
  if (fs::exists(kept)) return read(kept);
  fs::create_directories(own);
  const Mechanism robot = namedMechanism(robots[turn % robots.size()]);
  Random random(seed * 1000 + turn);
  DrawOptions draw;
  draw.seed = seed;
  Pair pair;
  pair.robot = robot.name;
  for (std::size_t at = 5 * turn;; ++at) {
    const BlindEffect drawn = drawEffects(robot, BlindKind::single, at, draw, random).front();
    const Effect& effect = *findEffect(drawn.effect);
    if (effect.decoded || !sitsAtJoints(effect)) continue;
    const auto first = static_cast<std::size_t>(random.uniform() * programs.size());
    const auto other =
        (first + 1 + static_cast<std::size_t>(random.uniform() * (programs.size() - 1))) % programs.size();
    const Excitation program = findExcitation(programs[first], robot);
    BlindEffect weak = drawn;
    Open open;
    std::optional<Trial> recorded;
    std::vector<Cause> rivals;
    for (int step = 0; step <= weaker && !recorded; ++step, weak = strengthened(robot, weak, weakening)) {
      open.truth = {&effect, findPlace(effect, robot, weak.at, weak.axis), weak.value, 0};
      ++pair.draws;
      Trial trial = played(robot, program, open.truth, seed * 100 + turn, "first");
      const Shown shown = looksLike(robot, trial, open, rivals, jobs);
      if (shown == Shown::nothing) break;
      if (shown == Shown::open) recorded = std::move(trial);
    }
    if (!recorded) continue;
    const Proposed next = proposedFor(robot, robots[turn % robots.size()], open, own);
    if (!next.separates) {
      ++pair.inseparable;
      continue;
    }
    const Excitation drawnNext = findExcitation(programs[other], robot);
    const auto after = [&](const Excitation& motion) {
      Comparison both(robot, {*recorded, played(robot, motion, open.truth, seed * 100 + turn + 50, "next")},
                      jobs);
      return both.logOdds(open.asFitted, open.rival);
    };
    pair.truth = describe(open.truth);
    pair.rival = describe(open.rival);
    pair.first = programs[first];
    pair.before = open.before;
    pair.proposed = next.name;
    pair.withProposed = after(next.motion);
    pair.random = programs[other];
    pair.withRandom = after(drawnNext);
    const json j{{"robot", pair.robot},
                 {"truth", pair.truth},
                 {"rival", pair.rival},
                 {"first", pair.first},
                 {"before", pair.before},
                 {"proposed", pair.proposed},
                 {"random", pair.random},
                 {"draws", pair.draws},
                 {"inseparable", pair.inseparable},
                 {"withProposed", pair.withProposed},
                 {"withRandom", pair.withRandom}};
    writeFile(kept, j.dump(1) + "\n");
    return pair;
  }
}

}  // namespace plumbline::bench
