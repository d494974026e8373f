#include <cmath>

#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

namespace {

/// A filter of first order on the commanded speed, which is one on the angle that it adds up to.
class FilteredJoint {
public:
  FilteredJoint(const EffectSettings& settings, double stepSeconds)
      : cycles_(sumOf(settings) / stepSeconds) {}
  /// Mean over the cycle.
  double cycle(double speed) {
    if (cycles_ <= 0) return speed;
    const double away = speed_ - speed, fades = std::expm1(-1 / cycles_);
    speed_ = speed + away * (1 + fades);
    return speed - away * cycles_ * fades;
  }
  double slack() const { return 0; }
  void restart() { speed_ = 0; }

private:
  double cycles_;     ///< its time constant
  double speed_ = 0;  ///< what it gives at the end of a cycle [rad/s]
};

}  // namespace

/// Joints follow commands through a filter with this time constant [s]; several add up.
const LeagueEffect commandLag{
    .id = "command_lag",
    .order = 470,
    .lower = 0,
    .upper = 1,
    .turn = 25,
    .command = [](const EffectSettings& settings,
                  const EffectRobot& robot) -> std::unique_ptr<CommandEffect> {
      return std::make_unique<JointCommandEffect<FilteredJoint>>(settings, robot.stepSeconds);
    },
};
MAKE_LEAGUE_EFFECT(commandLag);

}  // namespace plumbline::simulation
