#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// Whoever took a restart must not be the next to touch the ball, but for a tenth of a second that the kick
/// may last: otherwise the opponents get an indirect free kick where the ball is. (CheckFreeKickTakerFoul,
/// PunishFreeKickFoul)
class DoubleTouch : public Rule {
public:
  void play(Match& match) override;
};

}  // namespace plumbline::simulation
