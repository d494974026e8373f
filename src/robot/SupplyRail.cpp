#include "robot/SupplyRail.h"

#include <algorithm>

namespace plumbline {

namespace {

constexpr double smoothing = 0.01;  // [s]
constexpr double leastLeft = 0.1;   // below, a robot switches itself off

}  // namespace

void SupplyRail::take(double torques, double h) {
  if (most_ > 0) load_ += std::min(1.0, h / smoothing) * (torques / most_ - load_);
}

double SupplyRail::left(const JointPlant& drive) const {
  return drive.supplySag > 0 ? std::max(leastLeft, 1 - drive.supplySag * load_) : 1;
}

}  // namespace plumbline
