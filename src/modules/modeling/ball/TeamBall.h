#pragma once
#include <optional>
#include <vector>

#include "math/Types.h"

namespace plumbline {

/// A ball from a message, predicted to the present time; in the team's frame [m, m/s, s].
struct HeardBall {
  Vec2 position = Vec2::Zero(), velocity = Vec2::Zero();
  double deviation = 1;  ///< per axis [m]
  double age = 0;        ///< since it was seen [s]
};

/// The mean weighted by certainty of those that agree with the most certain one (within three deviations);
/// others are left out, because they saw the ball at another place. Nothing if there is none.
std::optional<HeardBall> combineBalls(const std::vector<HeardBall>& heard);

}  // namespace plumbline
