#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// At most three players of a team, the goalie among them, may be in their own penalty area. The last to
/// enter goes; if that is the goalie, the one of the others farthest from the goal (AnalyseFouls). Unless
/// such players go outside the field, this one is put 0.4 m outside the nearest edge of the area, but not
/// into the goal (PenalizeIllegelDefenseFoul).
class IllegalDefence : public Rule {
public:
  void judgePlayer(Match& match, Participant& player) override;
};

}  // namespace plumbline::simulation
