#include "modules/motion/StandMotion.h"

#include "modules/motion/WalkConfig.h"
#include "walking/engine/WalkEngine.h"

namespace plumbline {

MAKE_MODULE(StandMotion)

void StandMotion::init() { gaits_ = readWalkGaits(config); }

void StandMotion::update(StandOutput* theStandOutput) {
  theStandOutput->fadeSeconds = fadeSeconds;
  if (theRobotDescription->name == robot_) return;
  robot_ = theRobotDescription->name;
  const walking::WalkOutput stand = walking::WalkEngine(gaits_, theRobotDescription->model).stand();
  theStandOutput->targets.angles = stand.angles;
  theStandOutput->targets.set = stand.set;
}

}  // namespace plumbline
