#pragma once
#include <vector>

#include "simulation/replay/StartState.h"

namespace plumbline::simulation {

/// Fits the robots' states one step before row 0 so that this simulator agrees best with the torsos of the
/// first rows. Gauss-Newton over place and motion of each torso, starting from the rows' own values. `ball`
/// is present in its state of row 0. The rounding of sensors would turn the whole path by 0.0005 degrees if
/// row 0 alone were used.
std::vector<StartState> fitStarts(const std::vector<simspark::LeagueTrace>& robots,
                                  const std::vector<RobotModel>& models, const BodyState& ball,
                                  const WorldConfig& config);

}  // namespace plumbline::simulation
