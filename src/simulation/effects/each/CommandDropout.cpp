#include "simulation/effects/LeagueEffect.h"
#include "simulation/world/RandomStream.h"

namespace plumbline::simulation {

namespace {

class LostCycles : public CommandEffect {
public:
  LostCycles(double share, std::uint64_t stream) : share_(share), random_(1, stream) {}
  bool touches(JointId) const override { return share_ > 0; }
  void cycle(JointArray& speeds) override {
    if (share_ > 0 && random_.uniform(0, 1) < share_)
      speeds = held_;
    else
      held_ = speeds;
  }
  void restart() override { held_.fill(0); }

private:
  double share_;
  RandomStream random_;
  JointArray held_{};
};

}  // namespace

/// Share of the cycles whose commands are lost, all joints' at once: the speeds before stay.
const LeagueEffect commandDropout{
    .id = "command_dropout",
    .order = 20,
    .site = LeagueEffect::Site::everywhere,
    .lower = 0,
    .upper = 1,
    .turn = 10,
    .command = [](const EffectSettings& settings,
                  const EffectRobot& robot) -> std::unique_ptr<CommandEffect> {
      return std::make_unique<LostCycles>(settings.back().value, robot.stream);
    },
};
MAKE_LEAGUE_EFFECT(commandDropout);

}  // namespace plumbline::simulation
