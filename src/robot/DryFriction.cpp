#include "robot/DryFriction.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

namespace {

double fallen(double speed, double scale) {
  const double s = speed / scale;
  return std::exp(-s * s);
}

/// The square of the torque through the gear: the smaller of the two torques, if they press against each
/// other.
double squareThrough(JointPlant::Flow flow, const GearLoad& load) {
  const double motor = std::abs(load.motor), link = std::abs(load.link);
  if (load.motor * load.link <= 0) return 0;
  if (flow == JointPlant::Flow::motorDrives && motor <= link) return 0;
  if (flow == JointPlant::Flow::loadDrives && motor >= link) return 0;
  return std::pow(std::min(motor, link), 2);
}

}  // namespace

DryFriction dryFriction(const JointPlant& plant, double speed, const GearLoad& load) {
  double most = plant.coulomb;
  if (plant.stribeck > 0) most += plant.stribeck * fallen(speed, plant.stribeckSpeed);
  const double pressed = load.of(plant.loadIs);
  most += std::abs(plant.loadFriction * pressed + plant.linkLoadFriction * load.link);
  if (plant.loadStribeck > 0 || plant.quadraticLoadFriction > 0)
    most += fallen(speed, plant.loadStribeckSpeed) *
            (plant.loadStribeck * std::abs(pressed) +
             plant.quadraticLoadFriction * squareThrough(plant.quadraticFlow, load));
  return {most + plant.coulombForward, most + plant.coulombBackward};
}

}  // namespace plumbline
