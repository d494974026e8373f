// Files of effects, as a simulator and the diagnosis read them.
#include "fuzz/Readers.h"
#include "gap/diagnosis/ExplanationFile.h"
#include "robot/MechanismFile.h"
#include "simulation/world/EffectFile.h"

namespace plumbline::fuzz {
namespace {

void effectsFile(std::string_view bytes) {
  static const Mechanism robot = findMechanism("xl330_pendulum");
  const std::string path = scratchFile("effects.yaml", bytes);
  refusesInOneLine([&] {
    const auto settings = simulation::readEffects(path);
    const gap::Explanation causes = gap::causesOf(settings, robot);
    // What was taken is written and read back.
    const std::string text = simulation::effectsText(gap::settingsOf(causes), "again");
    const auto again = simulation::readEffects(scratchFile("again.yaml", text));
    require(gap::causesOf(again, robot) == causes, "effects change when they are read back");
  });
}

std::vector<std::string> effectsFileSeeds() {
  return {
      "effects:\n  - {effect: backlash, at: pendulum, value: 0.03}\n  - {effect: coulomb_friction, at: "
      "pendulum, value: 0.05}\n",
      "effects:\n  - {effect: command_delay, at: \"*\", value: 0.02}\n",
      "effects:\n  - effect: com_offset\n    at: pendulum\n    axis: x\n    value: 0.01\n", "effects: []\n"};
}

const Registered effectsFileTarget({"effectsFile", effectsFile, effectsFileSeeds, 1500});

}  // namespace
}  // namespace plumbline::fuzz
