#include "modules/motion/KickMotion.h"

namespace plumbline {

MAKE_MODULE(KickMotion)

void KickMotion::init() {
  name_ = config.get<std::string>("rightFoot");
  if (const RobotModel* robot = findObject<RobotModel>()) read(*robot);
}

void KickMotion::read(const RobotModel& robot) {
  const std::vector<motion::KeyframeMotion> motions = readMotions(config, robot);
  const motion::KeyframeMotion* kick = findMotion(motions, name_);
  if (!kick) config.fail("rightFoot", "there is no motion " + name_ + " in motions/");
  right_ = *kick;
  left_ = mirrored(*kick);
}

void KickMotion::update(KickMotionOutput* theKickMotionOutput) {
  if (theRobotDescription->type < 0) return;
  if (theRobotDescription->type != type_) {
    type_ = theRobotDescription->type;
    read(theRobotDescription->model);
    player_ = {};
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
