#include "gap/replay/Plant.h"

namespace plumbline::gap {

Mat3 rotationOfGround(const GroundPlant& ground) {
  const double angle = ground.slope.norm();
  if (!(angle > 0)) return Mat3::Identity();
  return Eigen::AngleAxisd(angle, ground.slope / angle).toRotationMatrix();
}

Plant nominalPlant(const Mechanism& mechanism) {
  Plant plant;
  plant.mechanism = mechanism;
  for (const auto& joint : mechanism.joints) plant.joints.push_back(JointPlant::nominal(joint));
  plant.footGain.assign(mechanism.feet.size(), 1);
  return plant;
}

}  // namespace plumbline::gap
