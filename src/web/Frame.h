#pragma once
#include <string>

#include "simspark/SceneState.h"

namespace plumbline::web {

/// Where everything is, as bytes, little-endian:
///
///     byte 1, byte number of robots, 2 bytes 0, double game time [s],
///     3 floats ball position [m], 4 int16 ball orientation x y z w [1/32767],
///     per robot: byte side (0 none, 1 left, 2 right), byte uniform number, byte type, byte number of parts,
///       3 floats torso position [m], per part: 3 int16 position from the torso's [0.1 mm], 4 int16
///       orientation
///
/// Axes are the field's; a part's are forward, left, up. Parts come in the order of the geometry; a robot
/// whose bodies are not those of its type has none. 7.5 kB with 22 robots.
std::string frameMessage(const simspark::SceneState& scene);

constexpr std::size_t frameHeaderBytes = 32, frameRobotBytes = 16, framePartBytes = 14;

}  // namespace plumbline::web
