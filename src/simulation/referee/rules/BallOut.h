#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// When the whole ball has left the field, the last touch decides. Over the side line there is a kick-in for
/// the other team. Behind a goal line there is a corner kick if the team of that goal touched it last, else a
/// goal kick. A ball that nobody has touched stays where it is. (CheckBallLeftField)
class BallOut : public Rule {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(bool, on, true, "", {}, "kick-in, corner kick, goal kick")
  };
  void play(Match& match) override;
};

}  // namespace plumbline::simulation
