#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

/// Crowding at the ball: with an opponent near it, the second and the third nearest player of a team must
/// keep away from it, but for the goalie and the team that kicks off. Off in the league, whose distances are
/// 0. (AnalyseFouls)
bool crowds(Match& match, const Participant& player);

}  // namespace plumbline::simulation
