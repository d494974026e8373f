#pragma once

namespace plumbline {

/// The acceleration of a free fall, for robots whose file does not say another, and of the league's server
/// [m/s^2].
inline constexpr double earthGravity = 9.81;

}  // namespace plumbline
