#include "modules/modeling/TorsoPoseProvider.h"

#include <cmath>

namespace plumbline {

MAKE_MODULE(TorsoPoseProvider)

void TorsoPoseProvider::update(TorsoPose* theTorsoPose) {
  if (!theRobotDescription->known()) return;
  if (theRobotDescription->name != robot_) {
    robot_ = theRobotDescription->name;
    height_.emplace(theRobotDescription->model);
  }
  withoutContact_ = theGroundContactState->contact ? 0 : withoutContact_ + theFrameInfo->cycleSeconds;
  const Vec3& up = theUprightVec->up;
  const bool lies = up.z() < std::cos(lyingTilt);
  const double height = lies ? height_->aboveLowestPoint(up, theFKModel->T_torso_link)
                             : height_->aboveFeet(up, theFKModel->T_torso_link);
  theTorsoPose->T_ground_torso =
      translation(0, 0, height) * rotationY(theTorsoAngles->pitch) * rotationX(theTorsoAngles->roll);
  theTorsoPose->valid = !lies && withoutContact_ < contactMemory;
}

}  // namespace plumbline
