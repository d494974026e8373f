#include <algorithm>

#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

namespace {

class AcceleratedJoint {
public:
  AcceleratedJoint(const EffectSettings& settings, double stepSeconds)
      : change_(settings.back().value * stepSeconds) {}
  double cycle(double speed) {
    speed_ = std::clamp(speed, speed_ - change_, speed_ + change_);
    return speed_;
  }
  double slack() const { return 0; }
  void restart() { speed_ = 0; }

private:
  double change_, speed_ = 0;  // [rad/s]
};

}  // namespace

/// The largest acceleration of a joint [rad/s^2]; of several the last one holds.
const LeagueEffect accelerationLimit{
    .id = "acceleration_limit",
    .order = 130,
    .lower = 1e-3,
    .upper = 1e6,
    .turn = 50,
    .command = [](const EffectSettings& settings,
                  const EffectRobot& robot) -> std::unique_ptr<CommandEffect> {
      return std::make_unique<JointCommandEffect<AcceleratedJoint>>(settings, robot.stepSeconds);
    },
};
MAKE_LEAGUE_EFFECT(accelerationLimit);

}  // namespace plumbline::simulation
