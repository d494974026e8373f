#pragma once
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "simulation/effects/CommandEffect.h"
#include "simulation/effects/SensorEffect.h"
#include "simulation/physics/Physics.h"
#include "simulation/world/EffectFile.h"

namespace plumbline::simulation {

/// Settings of one effect, in the order of their file.
using EffectSettings = std::vector<EffectSetting>;

/// What an effect with a state is made for.
struct EffectRobot {
  double stepSeconds = 0.02;
  std::uint64_t stream = 0;  ///< of the random numbers, one per robot
};

/// An effect that the league's robots, or the ground below them, can have. Each is in a file of its own in
/// each/ and registered by MAKE_LEAGUE_EFFECT; id, places and unit are those of
/// doc/reference/effects-file.md. The functions at the end define the effect; a null one changes nothing.
struct LeagueEffect {
  enum class Site { everywhere, joint, jointOrEverywhere, link, imu, foot, ground };

  std::string_view id;
  int order = 1000;  ///< its place in lists; those of the same order by their ids
  Site site = Site::joint;
  std::string_view axes = {};   ///< that it can be about, as "xyz"; empty: it has none
  double lower = 0, upper = 0;  ///< of the value
  int turn = 0;                 ///< effects of a lower turn change a command or a reading before it
  /// Changes a link's mass, centre of mass or speed where the effect is.
  void (*body)(Link& link, const EffectSetting& setting) = nullptr;
  /// What becomes of a motor's torque limit [N m].
  double (*torque)(double torque, double value) = nullptr;
  /// What becomes of commanded speeds on their way to the joints.
  std::unique_ptr<CommandEffect> (*command)(const EffectSettings& settings,
                                            const EffectRobot& robot) = nullptr;
  /// What becomes of readings on their way to the robot.
  std::unique_ptr<SensorEffect> (*sensor)(const EffectSettings& settings, const EffectRobot& robot) = nullptr;
  /// The ground stays the plane z = 0; a slope leans gravity instead, which is the same seen from the ground.
  void (*ground)(const EffectSettings& settings, Material ground, PhysicsConfig& physics) = nullptr;
};

/// Takes an effect in before main. One that is not whole, or a second one of the same id, ends the program
/// start: that is a mistake of the build.
class LeagueEffectLoader {
public:
  explicit LeagueEffectLoader(const LeagueEffect& effect);
};

/// MAKE_LEAGUE_EFFECT(backlash): in the effect's .cpp.
#define MAKE_LEAGUE_EFFECT(name) static const ::plumbline::simulation::LeagueEffectLoader name##Loader(name)

/// All of them, as lists name them.
const std::vector<const LeagueEffect*>& leagueEffects();
/// Null if there is none with that id.
const LeagueEffect* findLeagueEffect(std::string_view id);

/// An effect and what of a list is its own.
struct EffectInUse {
  const LeagueEffect* effect;
  EffectSettings settings;
};
/// Those of a list, in the order of their turns.
std::vector<EffectInUse> effectsInUse(const std::vector<EffectSetting>& settings);

}  // namespace plumbline::simulation
