#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// Before the kick-off the ball lies in the middle, and everybody stands in the own half; all this as soon as
/// somebody is there (UpdateBeforeKickOff). At the kick-off the other team stays out of the ring; players of
/// the side that kicks off may stand in it. Play is on when a player touches the ball, or after 15 s by a
/// drop ball (UpdateKickOff). The kick-off's team may score when an opponent has touched the ball, or one of
/// its own players outside the ring; with up to two robots in the game it always may (Update).
class KickOff : public Rule {
public:
  void begin(Match& match) override;
  void play(Match& match) override;
};

}  // namespace plumbline::simulation
