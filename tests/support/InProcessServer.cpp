#include "support/InProcessServer.h"

#include <cmath>

#include "math/Angle.h"
#include "simspark/LeagueRobots.h"
#include "simspark/ServerMessageWriter.h"

namespace plumbline::test {
namespace {

constexpr double dt = 0.02;

simspark::ForceReading reading(const simulation::FootForce& force) { return {force.point, force.force}; }

}  // namespace

InProcessServer::InProcessServer(const Setup& setup)
    : setup_(setup),
      robot_(simsparkRobot(setup_.type)),
      engine_(walking::WalkParameters{}, robot_.model()),
      control_(robot_.model()),
      vision_(setup_.seed) {
  robot_.restart(setup_.start, engine_.stand().angles);
  sense();
}

Pose3 InProcessServer::headPose() {
  // A body's frame in the world sits at its centre, which is where the head's camera is.
  return robot_.world().linkState(robot_.robot(), robot_.model().linkIndex("head")).pose;
}

void InProcessServer::sense() {
  const simulation::RobotReadings& now = robot_.sense();
  message_ = {};
  message_.time = 10 + time();
  message_.gameState.playMode = "PlayOn";
  if (cycle_ == 0) {
    message_.gameState.unum = 1;
    message_.gameState.side = setup_.leftSide ? "left" : "right";
  }
  message_.gyro = now.gyro;
  message_.acc = now.acc;
  for (int j = 0; j < numHumanoidJoints; ++j)
    if (const auto joint = static_cast<JointId>(j); robot_.model().has(joint))
      message_.angle[static_cast<std::size_t>(j)] = now.angle[static_cast<std::size_t>(j)];
  if (now.leftFoot) message_.leftFoot = reading(*now.leftFoot);
  if (now.rightFoot) message_.rightFoot = reading(*now.rightFoot);
  if (now.leftToe) message_.leftToe = reading(*now.leftToe);
  if (now.rightToe) message_.rightToe = reading(*now.rightToe);
  simspark::GroundTruth truth;
  truth.T_world_torso = torso();
  truth.ball = robot_.world().ball().pose.translation();
  if (cycle_ % 3 == 0) message_.see = vision_.see(headPose(), truth.ball);
  message_.groundTruth = truth;
}

std::string InProcessServer::message() {
  std::string text;
  simspark::appendServerMessage(text, message_, 6);
  return text;
}

void InProcessServer::walk(Vec2 velocity, double turn) {
  const simulation::RobotReadings& now = robot_.sense();
  const Vec3 place = torso().translation();
  const Mat3 R = torso().linear();
  if (std::abs(place.x()) > 13.5 || std::abs(place.y()) > 8.5) {
    const double toCentre = std::atan2(-place.y(), -place.x());
    turn = normalizeAngle(toCentre - std::atan2(R(1, 0), R(0, 0))) > 0 ? 1 : -1;
  }
  walking::WalkSensors sensors;
  sensors.angles = now.angle;
  sensors.torsoAngles = Vec2(std::atan2(R(2, 1), R(2, 2)), -std::asin(R(2, 0)));
  sensors.gyro = now.gyro;
  const walking::WalkOutput output = engine_.update({velocity, turn, true}, sensors);
  JointArray targets = output.angles;
  targets[headYaw] = 1.2 * std::sin(2 * pi * time() / 3);
  targets[headPitch] = 0.25 + 0.25 * std::sin(2 * pi * time() / 5);
  move(control_.update(now.angle, targets, dt));
}

void InProcessServer::move(const JointArray& speeds) {
  robot_.act(speeds);
  ++cycle_;
  sense();
}

void InProcessServer::standUp() {
  const Pose3 T = torso();
  const Vec3 forward = T.linear().col(0);
  robot_.restart(Pose2(T.translation().x(), T.translation().y(), std::atan2(forward.y(), forward.x())),
                 engine_.stand().angles);
  engine_.reset();
  control_.reset();
}

void InProcessServer::carry(const Pose2& place) {
  const double height = torso().translation().z();
  robot_.world().moveRobot(robot_.robot(),
                           translation(place.x(), place.y(), height + 0.005) * rotationZ(place.heading));
}

}  // namespace plumbline::test
