#include "ServoModules.h"

#include "ServoPlatform.h"
#include "walking/estimation/SoleContact.h"

namespace plumbline {

MAKE_MODULE(ServoSensors)
MAKE_MODULE(ServoWish)
MAKE_MODULE(ServoMotors)

void ServoSensors::update(FrameInfo* theFrameInfo) {
  const test::ServoWorld& world = object<test::ServoWorld>();
  theFrameInfo->time = world.robot->time();
  theFrameInfo->cycleSeconds = 1 / world.mechanism.controlHz;
  ++theFrameInfo->cycle;
}

void ServoSensors::update(PlayerInfo* thePlayerInfo) {
  thePlayerInfo->robot = object<test::ServoWorld>().mechanism.name;
}

void ServoSensors::update(JointData* theJointData) {
  const test::ServoWorld& world = object<test::ServoWorld>();
  theJointData->angles = world.humanoid.toModel(world.robot->readings().position);
}

void ServoSensors::update(SensorData* theSensorData) {
  const test::ServoWorld& world = object<test::ServoWorld>();
  const servo::ServoReadings& readings = world.robot->readings();
  const Mat3 R_torso_sensor = rotationOfRpy(world.mechanism.imu.rpy);
  theSensorData->gyro = R_torso_sensor * readings.gyro;
  theSensorData->acc = R_torso_sensor * readings.acc;
  theSensorData->shear = false;
  const auto [left, right] = twoFeet(world.mechanism, world.humanoid);
  const auto felt = [&](std::size_t foot) {
    return FootForceData(
        walking::soleContact(world.mechanism, world.mechanism.feet[foot], readings.footForce[foot]));
  };
  theSensorData->leftFoot = felt(left);
  theSensorData->rightFoot = felt(right);
}

void ServoWish::update(MotionRequest* theMotionRequest) {
  *theMotionRequest = object<test::ServoWorld>().wish;
}

void ServoMotors::execute() {
  test::ServoWorld& world = object<test::ServoWorld>();
  const std::vector<double> stiffness = world.humanoid.toMechanism(theServoRequest->stiffness);
  for (std::size_t j = 0; j < stiffness.size(); ++j)
    if (world.mechanism.joints[j].driver < 0) world.robot->setStiffness(static_cast<int>(j), stiffness[j]);
  world.robot->command(world.humanoid.toMechanism(theServoRequest->angles));
  world.robot->step();
}

}  // namespace plumbline
