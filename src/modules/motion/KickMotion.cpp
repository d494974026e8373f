#include "modules/motion/KickMotion.h"

#include "framework/ConfigurationError.h"

namespace plumbline {

MAKE_MODULE(KickMotion)

void KickMotion::init() {
  edited_ = findObject<EditedMotion>();
  if (const RobotModel* robot = findObject<RobotModel>()) read(*robot);
}

void KickMotion::read(const RobotModel& robot) {
  const std::vector<motion::KeyframeMotion> motions = readMotions(config, robot);
  const motion::KeyframeMotion* kick = findMotion(motions, rightFoot);
  if (!kick) config.refuse("rightFoot", missingMotion(motions, rightFoot));
  right_ = *kick;
  left_ = mirrored(*kick);
}

void KickMotion::update(KickMotionOutput* theKickMotionOutput) {
  if (!theRobotDescription->known()) return;
  if (theRobotDescription->name != robot_) {
    robot_ = theRobotDescription->name;
    read(theRobotDescription->model);
    player_ = {};
  }
  if (edited_ && edited_->saved() != saved_) {
    saved_ = edited_->saved();
    try {
      read(theRobotDescription->model);
    } catch (const ConfigurationError& error) {
      log.error() << "the kick stays as it was: " << error.what();
    }
  }
  const bool still = stillness_.update(theSensorData->gyro);
  if (theMotionSelection->motion == Motion::kick) {
    if (theMotionSelection->started) {
      const motion::KeyframeMotion& kick = theMotionRequest->kickFoot == Side::left ? left_ : right_;
      player_.start(shiftedToBall(kick, theMotionRequest->kickBall), theJointData->angles);
    }
    player_.step(theFrameInfo->cycleSeconds, still);
  }
  theKickMotionOutput->targets.angles = player_.angles();
  theKickMotionOutput->targets.set = player_.joints();
  theKickMotionOutput->finished = player_.finished();
}

}  // namespace plumbline
