#pragma once

namespace plumbline {

/// What is expected of a robot before anything was seen of it [m/s, rad/s, s].
inline constexpr double expectedWalkSpeed = 0.8, expectedTurnSpeed = 2, expectedGetUpSeconds = 4;

}  // namespace plumbline
