#pragma once

namespace plumbline {

/// What is within this angle of the head's axis is surely in the image [rad]; an image of the league reaches
/// 60 degrees.
inline constexpr double sureViewAngle = 0.9;

}  // namespace plumbline
