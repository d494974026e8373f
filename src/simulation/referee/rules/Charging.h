#pragma once
#include "simulation/referee/Match.h"

namespace plumbline::simulation {

/// Charging: running into an opponent. Of two standing opponents who touch, one charges that moves at 0.4 m/s
/// or more and at 0.2 m/s or more towards the collision; near the ball (1 m) only if it goes rather for the
/// opponent than for the ball (30 degrees off), or comes second to the ball on another way. Nobody charges if
/// both do, at the ball itself, as a goalie in the own area, within a second of touching the ball, or within
/// 0.2 s of a harmless collision. Speeds are means of three cycles. (AnalyseChargingFouls)
void judgeCharging(Match& match);

}  // namespace plumbline::simulation
