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
  for (std::size_t i = 0; i < 2; ++i) {
    const Mechanism::Foot& foot = world.mechanism.feet[i];
    const bool left = world.mechanism.links[static_cast<std::size_t>(foot.link)].name[0] == 'L';
    FootForceData& data = left ? theSensorData->leftFoot : theSensorData->rightFoot;
    const auto contact = walking::soleContact(world.mechanism, foot, readings.footForce[i]);
    data.contact = contact.has_value();
    if (!contact) continue;
    data.point = contact->point;
    data.force = contact->force;
  }
}

void ServoWish::update(MotionRequest* theMotionRequest) {
  const MotionRequest& wish = object<test::ServoWorld>().wish;
  theMotionRequest->motion = wish.motion;
  theMotionRequest->walkVelocity = wish.walkVelocity;
  theMotionRequest->walkTurn = wish.walkTurn;
  theMotionRequest->specialAction = wish.specialAction;
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
