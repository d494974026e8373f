#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// A player that took a restart must not be the next to touch the ball, except within the tenth of a second
/// that the kick may last. Otherwise the opponents get an indirect free kick where the ball is.
/// (CheckFreeKickTakerFoul, PunishFreeKickFoul)
class DoubleTouch : public Rule {
public:
  void play(Match& match) override;
};

}  // namespace plumbline::simulation
