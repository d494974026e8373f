#include "modules/modeling/AccEvaluator.h"

#include "math/Angle.h"

namespace plumbline {

MAKE_MODULE(AccEvaluator)

void AccEvaluator::parametersChanged() { support_.setAirborneSeconds(airborneSeconds); }

void AccEvaluator::init() { contacts_.reserve(4); }

void AccEvaluator::findContacts() {
  contacts_.clear();
  const RobotModel& model = theRobotDescription->model;
  const auto add = [&](JointId movedBy, const FootForceData& sensor) {
    const int index = model.linkOfJoint[movedBy];
    if (index < 0 || !sensor.contact) return;
    // The sensor's frame sits in the middle of the body, the link's on its joint.
    const Vec3 point = model.links[static_cast<std::size_t>(index)].com + sensor.point;
    contacts_.push_back({index, point, sensor.force.norm()});
  };
  add(lAnkleRoll, theSensorData->leftFoot);
  add(rAnkleRoll, theSensorData->rightFoot);
  add(lToePitch, theSensorData->leftToe);
  add(rToePitch, theSensorData->rightToe);
}

void AccEvaluator::update(Odometry* theOdometry) {
  if (theFrameInfo->restarted) {
    support_.reset();
    started_ = false;
  }
  const TorsoAngles& torso = *theTorsoAngles;
  Pose2 step(0, 0, started_ ? normalizeAngle(torso.heading - headingBefore_) : 0);
  headingBefore_ = torso.heading;
  started_ = true;

  findContacts();
  const Mat3 R_world_torso =
      (rotationZ(torso.heading) * rotationY(torso.pitch) * rotationX(torso.roll)).linear();
  const Pose2 overFeet =
      support_.update(R_world_torso, theFKModel->T_torso_link, contacts_, theFrameInfo->cycleSeconds);
  if (theFallState->lying()) {
    // Feet that touch the ground do not carry the robot then; it stays where it is.
  } else if (source == "feet") {
    step.position = overFeet.position;
  } else if (theWalkingEngineOutput) {
    step.position = theWalkingEngineOutput->odometry.position;
  }
  theOdometry->step = step;
  theOdometry->total = theOdometry->total * step;
}

}  // namespace plumbline
