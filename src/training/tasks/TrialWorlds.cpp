#include "training/tasks/TrialWorlds.h"

#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "math/Random.h"
#include "simspark/LeagueRobots.h"

namespace plumbline::training {
namespace {

constexpr double chance = 0.5;  // of each effect in each draw

std::vector<simulation::EffectSetting> drawn(const std::vector<simulation::EffectSetting>& all, int draw) {
  Random random(static_cast<std::uint64_t>(draw));
  std::vector<simulation::EffectSetting> some;
  for (const simulation::EffectSetting& one : all)
    if (random.uniform() < chance && draw > 0) some.push_back(one);
  return some;
}

}  // namespace

const std::vector<std::string> TrialWorlds::options = {"engine", "effects", "draws", "firstDraw"};

TrialWorlds::TrialWorlds(const TaskOptions& options, int type) : engine_(options.word("engine", "ode")) {
  const int draws = static_cast<int>(options.number("draws", 0, 0, 64));
  const int first = static_cast<int>(options.number("firstDraw", 0, 0, 1e6));
  const std::string file = options.word("effects", "");
  if (draws > 0 && file.empty())
    throw ConfigurationError("option draws: of what? give the file of effects too (option effects)");
  simulation::WorldConfig world;
  world.engine = engine_;
  const auto effects =
      file.empty() ? std::vector<simulation::EffectSetting>() : simulation::readEffects(file);
  try {
    for (int draw = first; draw < first + std::max(1, draws); ++draw) {
      world.effects = draws > 0 ? drawn(effects, draw) : effects;
      all_.push_back(std::make_unique<motion::MotionTrial>(type, world));
    }
  } catch (const std::invalid_argument& error) {  // an engine that there is not
    throw ConfigurationError(std::string("option engine: ") + error.what());
  }
}

int robotTypeOf(const TaskOptions& options, std::vector<std::string> own) {
  own.insert(own.begin(), "type");
  own.insert(own.end(), TrialWorlds::options.begin(), TrialWorlds::options.end());
  options.check(own);
  return static_cast<int>(options.number("type", 0, 0, numSimsparkTypes() - 1));
}

}  // namespace plumbline::training
