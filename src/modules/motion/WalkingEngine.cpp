#include "modules/motion/WalkingEngine.h"

#include "modules/motion/WalkConfig.h"

namespace plumbline {

MAKE_MODULE(WalkingEngine)

void WalkingEngine::init() { parameters_ = readWalkParameters(config); }

void WalkingEngine::update(WalkingEngineOutput* theWalkingEngineOutput) {
  if (theRobotDescription->type < 0) return;
  if (theRobotDescription->type != type_) {
    type_ = theRobotDescription->type;
    engine_.emplace(parameters_, theRobotDescription->model);
  }
  const bool selected = theMotionSelection->motion == Motion::walk;
  if (!selected || theMotionSelection->started || theFrameInfo->restarted) engine_->reset();
  walking::WalkOutput output;
  if (selected) {
    walking::WalkRequest request;
    request.walk = theMotionRequest->motion == Motion::walk;
    request.velocity = theMotionRequest->walkVelocity;
    request.turn = theMotionRequest->walkTurn;
    walking::WalkSensors sensors;
    sensors.angles = theJointData->angles;
    sensors.torsoAngles = Vec2(theTorsoAngles->roll, theTorsoAngles->pitch);
    sensors.gyro = theSensorData->gyro;
    sensors.footForce = {theSensorData->leftFoot.force.z() + theSensorData->leftToe.force.z(),
                         theSensorData->rightFoot.force.z() + theSensorData->rightToe.force.z()};
    sensors.dt = theFrameInfo->cycleSeconds;
    output = engine_->update(request, sensors);
  } else {
    output = engine_->stand();
  }
  theWalkingEngineOutput->targets.angles = output.angles;
  theWalkingEngineOutput->targets.set = output.set;
  theWalkingEngineOutput->odometry = output.odometry;
  theWalkingEngineOutput->standing = output.standing;
  theWalkingEngineOutput->velocity = output.velocity;
  theWalkingEngineOutput->turn = output.turn;
}

}  // namespace plumbline
