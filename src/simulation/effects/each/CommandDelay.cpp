#include <cmath>
#include <deque>

#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

namespace {

/// Over a cycle the motor turns at the mean of the commands that are in force during it.
class DelayedJoint {
public:
  DelayedJoint(const EffectSettings& settings, double stepSeconds) : cycles_(sumOf(settings) / stepSeconds) {}
  double cycle(double speed) {
    const double whole = std::floor(cycles_), rest = cycles_ - whole;
    const auto n = static_cast<std::size_t>(whole);
    sent_.push_front(speed);
    if (sent_.size() > n + 2) sent_.resize(n + 2);
    const auto at = [&](std::size_t i) { return i < sent_.size() ? sent_[i] : 0; };
    return (1 - rest) * at(n) + rest * at(n + 1);
  }
  double slack() const { return 0; }
  void restart() { sent_.clear(); }

private:
  double cycles_;
  std::deque<double> sent_;  ///< newest first
};

}  // namespace

/// Commands come later; several delays add up.
const LeagueEffect commandDelay{
    .id = "command_delay",
    .order = 10,
    .site = LeagueEffect::Site::jointOrEverywhere,
    .lower = 0,
    .upper = 1,
    .turn = 20,
    .command = [](const EffectSettings& settings,
                  const EffectRobot& robot) -> std::unique_ptr<CommandEffect> {
      return std::make_unique<JointCommandEffect<DelayedJoint>>(settings, robot.stepSeconds);
    },
};
MAKE_LEAGUE_EFFECT(commandDelay);

}  // namespace plumbline::simulation
