#include "modules/motion/KickMotion.h"

#include <algorithm>

#include "framework/ConfigurationError.h"
#include "framework/DebugSite.h"

namespace plumbline {

MAKE_MODULE(KickMotion)

void KickMotion::init() {
  edited_ = findObject<EditedMotion>();
  if (const RobotModel* robot = findObject<RobotModel>()) read(*robot);
}

void KickMotion::read(const RobotModel& robot) {
  robot_ = robot.name;
  kicks_ = readMotions(config, robot);
  std::erase_if(kicks_, [](const motion::KeyframeMotion& motion) { return !motion.kick; });
  std::ranges::stable_sort(kicks_, {},
                           [](const motion::KeyframeMotion& kick) { return kick.kick->distance; });
}

void KickMotion::start() {
  const MotionRequest& request = *theMotionRequest;
  const motion::KeyframeMotion* kick = findMotion(kicks_, request.kick);
  if (!kick && !request.kick.empty())
    log.error() << "there is no kick \"" << request.kick << "\" in motions/";
  if (!kick && request.kick.empty() && !kicks_.empty()) kick = &kicks_.front();
  motion::KeyframeMotion played;
  if (kick) {
    const bool otherFoot = (kick->ball.y() > 0) != (request.kickFoot == Side::left);
    played = shiftedToBall(otherFoot ? mirrored(*kick) : *kick, request.kickBall);
  }
  player_.start(played, theJointData->angles);
}

void KickMotion::update(KickMotionOutput* theKickMotionOutput) {
  if (!theRobotDescription->known()) return;
  if (theRobotDescription->name != robot_) {
    read(theRobotDescription->model);
    robot_ = theRobotDescription->name;
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
    if (theMotionSelection->started) start();
    player_.step(theFrameInfo->cycleSeconds, still);
  }
  theKickMotionOutput->targets.angles = player_.angles();
  theKickMotionOutput->targets.set = player_.joints();
  theKickMotionOutput->finished = player_.finished();
}

}  // namespace plumbline
