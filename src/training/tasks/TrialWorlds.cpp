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

int checkedType(int type) {
  if (type >= numSimsparkTypes())
    throw ConfigurationError("option type: there is no robot of type " + std::to_string(type) +
                             "; there are types 0 to " + std::to_string(numSimsparkTypes() - 1));
  return type;
}

TrialWorlds::TrialWorlds(const WorldOptions& options) : engine_(options.robot.engine) {
  const int draws = options.draws, first = options.firstDraw, type = checkedType(options.robot.type);
  const std::string& file = options.robot.effects;
  if (draws > 0 && file.empty())
    throw ConfigurationError("option draws: of what? give the file of effects too (option effects)");
  simulation::WorldConfig world;
  world.engine = engine_;
  const auto effects =
      file.empty() ? std::vector<simulation::EffectSetting>() : simulation::readEffects(file);
  try {
    for (int draw = first; draw < first + std::max(1, draws); ++draw) {
      world.effects = draws > 0 ? drawn(effects, draw) : effects;
      all_.push_back(std::make_unique<MotionTrial>(type, world));
    }
  } catch (const std::invalid_argument& error) {  // an engine that there is not
    throw ConfigurationError(std::string("option engine: ") + error.what());
  }
}

}  // namespace plumbline::training
