#include "modules/motion/SpecialActions.h"

namespace plumbline {

MAKE_MODULE(SpecialActions)

void SpecialActions::init() {
  // Where main knows the robot, a broken file is told before anything else starts.
  if (const RobotModel* robot = findObject<RobotModel>()) readMotions(config, *robot);
}

void SpecialActions::start() {
  const motion::KeyframeMotion* motion = findMotion(motions_, theMotionSelection->specialAction);
  if (!motion)
    log.error() << "there is no motion \"" << theMotionSelection->specialAction << "\" in motions/";
  player_.start(motion ? *motion : motion::KeyframeMotion{}, theJointData->angles);
}

void SpecialActions::update(SpecialActionsOutput* theSpecialActionsOutput) {
  if (!theRobotDescription->known()) return;
  if (theRobotDescription->name != robot_) {
    robot_ = theRobotDescription->name;
    motions_ = readMotions(config, theRobotDescription->model);
    player_ = {};
  }
  const bool still = stillness_.update(theSensorData->gyro);
  if (theMotionSelection->motion == Motion::specialAction) {
    if (theMotionSelection->started) start();
    player_.step(theFrameInfo->cycleSeconds, still);
  }
  theSpecialActionsOutput->targets.angles = player_.angles();
  theSpecialActionsOutput->targets.set = player_.joints();
  theSpecialActionsOutput->finished = player_.finished();
}

}  // namespace plumbline
