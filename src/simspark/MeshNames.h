#pragma once
#include <string_view>

namespace plumbline::simspark {

/// How the names of meshes in a monitor's scene begin by which robots and the ball are found.
inline constexpr std::string_view bodyMesh = "models/naobody", ballMesh = "models/soccerball.obj";

}  // namespace plumbline::simspark
