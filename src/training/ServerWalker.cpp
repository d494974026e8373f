#include "training/ServerWalker.h"

#include <stdexcept>

#include "simspark/LeagueRobots.h"
#include "training/FeltFeet.h"

namespace plumbline::training {
namespace {

constexpr double cycleSeconds = ServerRobot::cycleSeconds;

}  // namespace

ServerWalker::ServerWalker(int type, const walking::WalkGaits& gaits, const SimSparkAddress& address)
    : Walker(simsparkRobot(type), gaits, cycleSeconds), robot_(type, address) {
  restart();
}

void ServerWalker::push(const Vec3&) { throw std::logic_error("robots of a server cannot be pushed"); }
void ServerWalker::move(const Vec2&) {
  throw std::logic_error("robots of a server cannot be moved while they walk");
}
Vec2 ServerWalker::comVelocity() { throw std::logic_error("a server does not send the true velocity"); }

walking::WalkSensors ServerWalker::sense() {
  walking::WalkSensors sensors;
  sensors.angles = robot_.readings().angle;
  sensors.gyro = robot_.readings().gyro;
  sensors.feet = feltFeet(robot_.readings());
  sensors.torsoAngles = Vec2(robot_.attitude().roll(), robot_.attitude().pitch());
  return sensors;
}

void ServerWalker::act(const walking::WalkOutput& out, const walking::WalkSensors&) {
  robot_.drive(lookingAround(out.angles, cycleSeconds * static_cast<double>(robot_.cycles())));
}

}  // namespace plumbline::training
