#include "gap/effects/Effect.h"

#include <algorithm>

namespace plumbline::gap {

void atJoints(Plant& plant, const Place& place, const std::function<void(JointPlant&)>& change) {
  const Mechanism& robot = plant.mechanism;
  std::vector<int> at{place.index};
  if (place.site == Site::everywhere) {
    if (place.index < 0) {
      for (JointPlant& joint : plant.joints) change(joint);
      return;
    }
    at = robot.groups[static_cast<std::size_t>(place.index)].joints;
  }
  for (int joint = 0; joint < robot.numJoints(); ++joint) {
    const auto sharesMotor = [&](int other) { return robot.motorOf(joint) == robot.motorOf(other); };
    if (std::ranges::any_of(at, sharesMotor)) change(plant.joints[static_cast<std::size_t>(joint)]);
  }
}

Vec3 unitVector(char axis) {
  return axis == 'x' ? Vec3::UnitX() : axis == 'y' ? Vec3::UnitY() : Vec3::UnitZ();
}

}  // namespace plumbline::gap
