#pragma once
#include <string>

#include "field/FieldSize.h"

namespace plumbline::web {

/// All that never changes, as JSON: {"kind":"geometry","field":{...},"types":[{"parts":[...]}]}. A page that
/// reads it need not know any robot. field: length, width, goalWidth, goalDepth, goalHeight, barDiameter,
/// ballRadius, lines [[x,y,x,y],...]. A part, in the order of a frame's poses: name, shape ("box", "sphere",
/// "capsule" along z), size (a box's edges; radius; radius and length of the cylinder) [m].
std::string geometryMessage(const FieldSize& field);

}  // namespace plumbline::web
