#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// Crowding at the ball: with an opponent near it, the second and the third nearest player of a team must
/// keep away from it, but for the goalie and the team that kicks off. Off in the league since 2017, by
/// distances of 0. (AnalyseFouls)
class Crowding : public Rule {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(bool, on, false, "", {}, "whether it is a foul: not in the league since 2017")
    PARAMETER(double, minOpponent, 0.8, "m", Range::atLeast(0),
              "of the nearest opponent from the ball, for the rule to hold")
    PARAMETER(double, minSecond, 0.4, "m", Range::atLeast(0),
              "of a team's second nearest player from the ball")
    PARAMETER(double, minThird, 1, "m", Range::atLeast(0), "of its third nearest")
  };
  void judgePlayer(Match& match, Participant& player) override;
};

}  // namespace plumbline::simulation
