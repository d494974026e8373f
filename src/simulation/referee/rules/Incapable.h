#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// A player that lies for more than 15 s or does not stand for more than 30 s is put outside the field; a
/// goalie has 30 and 60 s. (AnalyseFouls)
class Incapable : public Rule {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(bool, on, true, "", {}, "whether it is a foul")
    PARAMETER(double, notStanding, 30, "s", Range::atLeast(0), "a player need not stand")
    PARAMETER(double, onGround, 15, "s", Range::atLeast(0), "it may lie")
    PARAMETER(double, goalieNotStanding, 60, "s", Range::atLeast(0), "a goalie need not stand")
    PARAMETER(double, goalieOnGround, 30, "s", Range::atLeast(0), "it may lie")
  };
  void judgePlayer(Match& match, Participant& player) override;
};

}  // namespace plumbline::simulation
