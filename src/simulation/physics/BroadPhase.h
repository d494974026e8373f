#pragma once
#include <Eigen/Geometry>
#include <cstddef>
#include <iterator>
#include <vector>

#include "simulation/physics/Islands.h"

namespace plumbline::simulation {

inline Eigen::AlignedBox3d sphereBox(const Vec3& centre, double radius) {
  return {Vec3(centre.array() - radius), Vec3(centre.array() + radius)};
}

/// What may touch, by boxes around assemblies. Calls alone(handle, assembly, box) for each of them, and
/// together(handleA, a, handleB, b, overlap) for two whose boxes overlap, handles ascending. `boxes` is room
/// that is used again.
template <class EngineAssembly, class Alone, class Together>
void findNear(const AssemblyMap<EngineAssembly>& assemblies, std::vector<Eigen::AlignedBox3d>& boxes,
              const Alone& alone, const Together& together) {
  boxes.clear();
  for (const auto& [handle, assembly] : assemblies) boxes.push_back(assembly->bounds());
  std::size_t i = 0;
  for (auto a = assemblies.begin(); a != assemblies.end(); ++a, ++i) {
    alone(a->first, *a->second, boxes[i]);
    std::size_t j = i + 1;
    for (auto b = std::next(a); b != assemblies.end(); ++b, ++j)
      if (boxes[i].intersects(boxes[j]))
        together(a->first, *a->second, b->first, *b->second, boxes[i].intersection(boxes[j]));
  }
}

}  // namespace plumbline::simulation
