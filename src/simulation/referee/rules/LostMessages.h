#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// Words that do not reach others, as on a server under load. Off in the league. Which ones is drawn from the
/// words' own numbers, so a loss does not change others.
class LostMessages : public Rule {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(double, share, 0, "", Range(0, 1),
              "not in the league: of the words that a player says to another one; by lot, from the seed")
  };
  bool loses(const Rules& rules, const Words& words) const override;
};

}  // namespace plumbline::simulation
