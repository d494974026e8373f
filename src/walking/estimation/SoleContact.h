#pragma once
#include <optional>
#include <vector>

#include "robot/Mechanism.h"
#include "walking/estimation/WalkSensors.h"

namespace plumbline::walking {

/// Where the ground presses on a sole, from its force sensors [N], which measure across the sole alone;
/// nothing below 1 N. Throws std::out_of_range for fewer forces than sensors.
inline std::optional<FootContact> soleContact(const Mechanism& robot, const Mechanism::Foot& foot,
                                              const std::vector<double>& forces) {
  constexpr double leastForce = 1;  // [N]
  double sum = 0;
  Vec3 centre = Vec3::Zero();
  for (std::size_t k = 0; k < foot.sensors.size(); ++k) {
    sum += forces.at(k);
    centre += forces[k] * foot.sensors[k].position;
  }
  if (sum < leastForce) return std::nullopt;
  return FootContact{centre / sum - robot.links[static_cast<std::size_t>(foot.link)].com, Vec3(0, 0, sum)};
}

}  // namespace plumbline::walking
