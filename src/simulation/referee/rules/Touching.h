#pragma once
#include "field/TeamSize.h"
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// Of players who touch each other, directly or through others, more than two are too many. The one that came
/// last is called for it, if its team has at least half of them, otherwise one of the opponents; never a
/// goalie. Unless such players go outside the field, it is put 0.4 m away from the others' middle.
/// (AgentCollisionHandler, AnalyseTouchGroups, PenalizeTouchingFoul)
class Touching : public Rule {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(bool, on, true, "", {}, "whether it is a foul")
    PARAMETER(int, maxGroup, 2, "", Range(1, 2 * teamSize), "players who touch each other")
    PARAMETER(bool, putOutside, false, "", {}, "of the field, instead of away from the others")
  };
  void judgeGroups(Match& match) override;
};

}  // namespace plumbline::simulation
