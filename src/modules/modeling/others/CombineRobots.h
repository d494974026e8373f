#pragma once
#include <vector>

#include "representations/modeling/OtherRobots.h"

namespace plumbline {

/// Own sight and what mates say, of each robot (team and number) one: a robot seen within `ownSeconds` as it
/// is seen; otherwise the mean of both weighted by their covariances where they agree within three
/// deviations, else what is younger.
std::vector<OtherRobot> combineRobots(const std::vector<OtherRobot>& seen,
                                      const std::vector<OtherRobot>& heard, double now, double ownSeconds);

}  // namespace plumbline
