#pragma once
#include <vector>

#include "simulation/replay/StartState.h"

namespace plumbline::simulation {

/// The robots' states one step before row 0 from which this simulator comes nearest to the torsos of the
/// first rows: Gauss-Newton over place and motion of each torso, from what the rows say themselves; `ball` is
/// there, too, in its state of row 0. Sensors are rounded so that a start taken from row 0 alone turns the
/// whole way by 0.0005 degrees.
std::vector<StartState> fitStarts(const std::vector<simspark::LeagueTrace>& robots,
                                  const std::vector<RobotModel>& models, const BodyState& ball,
                                  const WorldConfig& config);

}  // namespace plumbline::simulation
