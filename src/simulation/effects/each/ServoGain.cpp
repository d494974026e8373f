#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

namespace {

class GainedJoint {
public:
  GainedJoint(const EffectSettings& settings, double) {
    for (const EffectSetting& setting : settings) gain_ *= setting.value;
  }
  double cycle(double speed) const { return gain_ * speed; }
  double slack() const { return 0; }
  void restart() {}

private:
  double gain_ = 1;
};

}  // namespace

/// A factor on the speed, as the agent's own control loop around a velocity motor makes it.
const LeagueEffect servoGain{
    .id = "servo_gain",
    .order = 30,
    .lower = 0,
    .upper = 10,
    .turn = 30,
    .command = [](const EffectSettings& settings,
                  const EffectRobot& robot) -> std::unique_ptr<CommandEffect> {
      return std::make_unique<JointCommandEffect<GainedJoint>>(settings, robot.stepSeconds);
    },
};
MAKE_LEAGUE_EFFECT(servoGain);

}  // namespace plumbline::simulation
