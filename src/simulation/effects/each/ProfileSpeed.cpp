#include <algorithm>

#include "simulation/effects/LeagueEffect.h"

namespace plumbline::simulation {

namespace {

class ProfiledJoint {
public:
  ProfiledJoint(const EffectSettings& settings, double)
      : fastest_(std::ranges::min(settings, {}, &EffectSetting::value).value) {}
  double cycle(double speed) const { return std::clamp(speed, -fastest_, fastest_); }
  double slack() const { return 0; }
  void restart() {}

private:
  double fastest_;  // [rad/s]
};

}  // namespace

/// The largest speed that a joint is asked for [rad/s]; of several the smallest holds.
const LeagueEffect profileSpeed{
    .id = "profile_speed",
    .order = 440,
    .site = LeagueEffect::Site::jointOrEverywhere,
    .lower = 1e-3,
    .upper = 1e3,
    .turn = 40,
    .command = [](const EffectSettings& settings,
                  const EffectRobot& robot) -> std::unique_ptr<CommandEffect> {
      return std::make_unique<JointCommandEffect<ProfiledJoint>>(settings, robot.stepSeconds);
    },
};
MAKE_LEAGUE_EFFECT(profileSpeed);

}  // namespace plumbline::simulation
