#include "ScriptedModules.h"

#include "ScriptedPlatform.h"

namespace plumbline {

MAKE_MODULE(ScriptedSensors)
MAKE_MODULE(ScriptedWish)
MAKE_MODULE(ScriptedMotors)

void ScriptedSensors::update(FrameInfo* theFrameInfo) {
  theFrameInfo->time = object<test::ScriptedWorld>().robot.time();
  ++theFrameInfo->cycle;
}

void ScriptedSensors::update(JointData* theJointData) {
  theJointData->angles = object<test::ScriptedWorld>().robot.sense().angle;
}

void ScriptedSensors::update(SensorData* theSensorData) {
  const simulation::RobotReadings& readings = object<test::ScriptedWorld>().robot.sense();
  theSensorData->gyro = readings.gyro;
  theSensorData->acc = readings.acc;
  theSensorData->leftFoot = FootForceData(readings.leftFoot);
  theSensorData->rightFoot = FootForceData(readings.rightFoot);
}

void ScriptedWish::update(MotionRequest* theMotionRequest) {
  const bool walks = theFrameInfo->time >= object<test::ScriptedOptions>().walkAfter;
  theMotionRequest->motion = walks ? Motion::walk : Motion::stand;
}

void ScriptedMotors::execute() { object<test::ScriptedWorld>().robot.act(theJointRequestWithSpeeds->speeds); }

}  // namespace plumbline
