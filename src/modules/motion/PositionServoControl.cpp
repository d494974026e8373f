#include "modules/motion/PositionServoControl.h"

#include "modules/motion/WalkConfig.h"
#include "robot/MechanismFile.h"

namespace plumbline {

MAKE_MODULE(PositionServoControl)

void PositionServoControl::init() { gaits_ = readWalkGaits(config); }

void PositionServoControl::begin() {
  lead_->reset();
  targets_ = JointTargets();
  targets_.angles = theJointData->angles;
  targets_.set.fill(true);
}

void PositionServoControl::update(ServoRequest* theServoRequest) {
  if (!theRobotDescription->known()) return;
  if (theRobotDescription->name != robot_) {
    robot_ = theRobotDescription->name;
    lead_ = std::make_unique<walking::ServoLead>(findMechanism(robot_));
    begin();
  } else if (theFrameInfo->restarted) {
    begin();
  }
  const JointTargets& wanted = theJointRequest->targets;
  for (std::size_t j = 0; j < maxJoints; ++j) {
    if (!wanted.set[j]) continue;
    targets_.angles[j] = wanted.angles[j];
    targets_.stiffness[j] = wanted.stiffness[j];
  }
  const double leftShare = theWalkingEngineOutput->leftShare;
  const walking::ServoCommand& command =
      lead_->command({targets_.angles, targets_.set, targets_.stiffness, leftShare}, gaits_.base,
                     Vec2(theTorsoAngles->roll, theTorsoAngles->pitch), theFrameInfo->cycleSeconds);
  theServoRequest->angles = lead_->humanoid().toModel(command.target);
  theServoRequest->stiffness = lead_->humanoid().toModel(command.stiffness);
}

}  // namespace plumbline
