#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// After 300 s of play the clock stops for the second half's kick-off, after 600 s the game is over; with
/// singleHalf it is over after 300 s. With changeSides (off in the league, whose agents are not informed)
/// teams change ends between the halves. There is no extra time. (CheckTime, SwapTeamSides)
class HalfTime : public Rule {
public:
  void begin(Match& match) override;
};

}  // namespace plumbline::simulation
