#pragma once
#include <vector>

#include "representations/modeling/OtherRobots.h"

namespace plumbline {

/// Combines own sight and messages of team mates to one estimate per robot (team and number). A robot seen
/// within `ownSeconds` is taken as it is seen. Otherwise it is the mean of both, weighted by their
/// covariances, if they agree within three deviations; else the newer one.
std::vector<OtherRobot> combineRobots(const std::vector<OtherRobot>& seen,
                                      const std::vector<OtherRobot>& heard, double now, double ownSeconds);

}  // namespace plumbline
