#include "modules/modeling/TorsoPoseProvider.h"

#include <cmath>

namespace plumbline {

MAKE_MODULE(TorsoPoseProvider)

void TorsoPoseProvider::init() {
  lyingTilt_ = config.get<double>("lyingTilt", {0, 3.2});
  contactMemory_ = config.get<double>("contactMemory", {0, 10});
}

void TorsoPoseProvider::update(TorsoPose* theTorsoPose) {
  if (theRobotDescription->type != type_) {
    type_ = theRobotDescription->type;
    height_.emplace(theRobotDescription->model);
  }
  withoutContact_ = theGroundContactState->contact ? 0 : withoutContact_ + theFrameInfo->cycleSeconds;
  const Vec3& up = theUprightVec->up;
  const bool lies = up.z() < std::cos(lyingTilt_);
  const double height = lies ? height_->aboveLowestPoint(up, theFKModel->T_torso_link)
                             : height_->aboveFeet(up, theFKModel->T_torso_link);
  theTorsoPose->T_ground_torso =
      translation(0, 0, height) * rotationY(theTorsoAngles->pitch) * rotationX(theTorsoAngles->roll);
  theTorsoPose->valid = !lies && withoutContact_ < contactMemory_;
}

}  // namespace plumbline
