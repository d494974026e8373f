#include "modules/motion/SpecialActions.h"

#include "framework/ConfigurationError.h"
#include "framework/DebugSite.h"

namespace plumbline {

MAKE_MODULE(SpecialActions)

void SpecialActions::init() {
  edited_ = findObject<EditedMotion>();
  // Where main knows the robot, a broken file is reported before anything else starts.
  if (const RobotModel* robot = findObject<RobotModel>()) read(*robot);
}

namespace {

std::vector<std::string> namesOf(const std::vector<motion::KeyframeMotion>& motions) {
  std::vector<std::string> names;
  for (const motion::KeyframeMotion& motion : motions) names.push_back(motion.name);
  return names;
}

}  // namespace

void SpecialActions::read(const RobotModel& robot) {
  robot_ = robot.name;
  motions_ = readMotions(config, robot);
}

void SpecialActions::start() {
  const std::string& name = theMotionSelection->specialAction;
  if (edited_ && name == EditedMotion::name) return player_.start(edited_->draft(), theJointData->angles);
  const motion::KeyframeMotion* motion = findMotion(motions_, name);
  if (!motion) log.error() << "there is no motion \"" << name << "\" in motions/";
  player_.start(motion ? *motion : motion::KeyframeMotion{}, theJointData->angles);
}

void SpecialActions::update(SpecialActionsOutput* theSpecialActionsOutput) {
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
      log.error() << "the motions stay as they were: " << error.what();
    }
  }
  OUTPUT_BY_VALUE("module:SpecialActions:motions", namesOf(motions_));
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
