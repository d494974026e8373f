#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

/// A player that lies for more than 15 s or does not stand for more than 30 s is put beside the field; a
/// goalie has 30 and 60 s. (AnalyseFouls)
bool incapable(const Match& match, const Participant& player);

}  // namespace plumbline::simulation
