#include "gap/effects/Effect.h"

namespace plumbline::gap {

void atJoints(Plant& plant, const Place& place, const std::function<void(JointPlant&)>& change) {
  if (place.site == Site::everywhere) {
    for (JointPlant& joint : plant.joints) change(joint);
    return;
  }
  const Mechanism& robot = plant.mechanism;
  for (int joint = 0; joint < robot.numJoints(); ++joint) {
    if (robot.motorOf(joint) == robot.motorOf(place.index))
      change(plant.joints[static_cast<std::size_t>(joint)]);
  }
}

Vec3 unitVector(char axis) {
  return axis == 'x' ? Vec3::UnitX() : axis == 'y' ? Vec3::UnitY() : Vec3::UnitZ();
}

}  // namespace plumbline::gap
