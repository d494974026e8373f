#pragma once
#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// Kick-in, corner kick, goal kick and free kicks. For a second nothing happens; then the ball is laid at its
/// place. Own players nearer than 0.5 m are moved off to that, opponents within 2 m are put 2.5 m away (at a
/// goal kick: out of the penalty area). So it stays until a player touches the ball, or for 15 s: then it is
/// dropped. A goal kick is over when the ball has left the penalty area. A free kick is not in a penalty area
/// but at its corner. Kick-ins and free kicks are indirect. (UpdateKickIn, UpdateFreeKick, UpdateGoalKick,
/// UpdateCornerKick)
class Restart : public Rule {
public:
  void play(Match& match) override;
};

}  // namespace plumbline::simulation
