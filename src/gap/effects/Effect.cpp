#include "gap/effects/Effect.h"

namespace plumbline::gap {

void atJoints(Plant& plant, const Place& place, const std::function<void(JointPlant&)>& change) {
  if (place.site == Site::everywhere) {
    for (JointPlant& joint : plant.joints) change(joint);
    return;
  }
  const auto& joints = plant.mechanism.joints;
  const auto motorOf = [&](int joint) {
    const int driver = joints[static_cast<std::size_t>(joint)].driver;
    return driver < 0 ? joint : driver;
  };
  for (int joint = 0; joint < plant.mechanism.numJoints(); ++joint) {
    if (motorOf(joint) == motorOf(place.index)) change(plant.joints[static_cast<std::size_t>(joint)]);
  }
}

Vec3 unitVector(char axis) {
  return axis == 'x' ? Vec3::UnitX() : axis == 'y' ? Vec3::UnitY() : Vec3::UnitZ();
}

}  // namespace plumbline::gap
