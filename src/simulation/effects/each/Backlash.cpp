#include <algorithm>

#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

namespace {

class JointWithPlay {
public:
  JointWithPlay(const EffectSettings& settings, double stepSeconds)
      : step_(stepSeconds), play_(sumOf(settings)) {}
  double cycle(double speed) {
    if (play_ <= 0) return speed;
    const double moved = slack_ + speed * step_;
    slack_ = std::clamp(moved, -play_ / 2, play_ / 2);
    return (moved - slack_) / step_;
  }
  double slack() const { return slack_; }
  void restart() { slack_ = 0; }

private:
  double step_, play_, slack_ = 0;
};

}  // namespace

/// The play is crossed before the link moves; within it the link does not move.
const LeagueEffect backlash{
    .id = "backlash",
    .order = 110,
    .lower = 0,
    .upper = 0.5,
    .turn = 60,
    .command = [](const EffectSettings& settings,
                  const EffectRobot& robot) -> std::unique_ptr<CommandEffect> {
      return std::make_unique<JointCommandEffect<JointWithPlay>>(settings, robot.stepSeconds);
    },
};
MAKE_LEAGUE_EFFECT(backlash);

}  // namespace plumbline::simulation
