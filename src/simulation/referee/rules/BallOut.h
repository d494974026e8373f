#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// When the ball, as a whole, has left the field it depends on who touched it last: over the side line a
/// kick-in for the others; behind a goal line a corner kick if its own team was last, else a goal kick. A
/// ball that nobody has touched stays where it is. (CheckBallLeftField)
class BallOut : public Rule {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(bool, on, true, "", {}, "kick-in, corner kick, goal kick")
  };
  void play(Match& match) override;
};

}  // namespace plumbline::simulation
