#include "tactics/approach/WalkToPose.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

namespace {
constexpr double straightAhead = 0.2;  ///< a target within this angle is straight ahead [rad]
}  // namespace

Vec2 limitVelocity(const Vec2& velocity, const WalkToPoseParameters& parameters) {
  const double maxX = velocity.x() >= 0 ? parameters.maxForward : parameters.maxBackward;
  const double share = std::hypot(velocity.x() / maxX, velocity.y() / parameters.maxSideways);
  return share > 1 ? Vec2(velocity / share) : velocity;
}

WalkCommand walkToPose(const Pose2& T_robot_target, const WalkToPoseParameters& parameters, bool sprinting) {
  const auto limitTurn = [&](double turn) {
    return std::clamp(turn, -parameters.maxTurn, parameters.maxTurn);
  };
  const double distance = T_robot_target.position.norm();
  WalkCommand command;
  if (distance < parameters.nearDistance) {
    command.velocity = limitVelocity(parameters.positionGain * T_robot_target.position, parameters);
    command.turn = limitTurn(parameters.headingGain * T_robot_target.heading);
    return command;
  }
  const double bearing = std::atan2(T_robot_target.y(), T_robot_target.x());
  double gain = parameters.headingGain, ahead = parameters.curveSpeed;
  const bool far = parameters.sprintBearing > 0 && distance > parameters.sprintDistance;
  if (far && parameters.alignGain > 0) gain = parameters.alignGain;
  if (far) ahead = std::min(ahead, parameters.alignSpeed);
  command.turn = limitTurn(gain * bearing);
  const double curve = ahead * (1 - parameters.turnEffort * std::abs(command.turn) / parameters.maxTurn);
  if (std::abs(bearing) < parameters.turnFirst) {
    // Slower while still turning: a fast walk in a tight curve swings out and loses time.
    double speed = parameters.maxForward * std::pow(std::cos(bearing), 3);
    if (parameters.sprintBearing > 0) {
      const double straight = std::max(parameters.sprintBearing,
                                       std::asin(std::min(1.0, parameters.sprintPassDistance / distance)));
      const double most = sprinting ? std::max(straight, parameters.sprintHold) : straight;
      command.sprint = far && std::abs(bearing) < most;
      if (command.sprint) {
        command.turn =
            std::clamp(parameters.sprintGain * bearing, -parameters.sprintTurn, parameters.sprintTurn);
        speed = parameters.maxForward;  // less of it would end the sprint
      } else {                          // what is left of the walk's effort turns
        speed = std::min(speed, curve);
      }
    }
    command.velocity = limitVelocity({std::min(speed, parameters.positionGain * distance), 0}, parameters);
  }
  if (parameters.turnWalking > 0 && !command.sprint && std::abs(bearing) > straightAhead) {
    const double speed = parameters.turnWalking * std::min(parameters.positionGain * distance, curve);
    command.velocity = limitVelocity(speed / distance * T_robot_target.position, parameters);
  }
  return command;
}

WalkCommand walkPast(const Vec2& wayPoint, const WalkToPoseParameters& parameters, bool sprinting) {
  const double distance = wayPoint.norm();
  if (distance < 1e-6) return {};
  const double ahead =
      std::max(distance, parameters.nearDistance + parameters.maxForward / parameters.positionGain);
  const Vec2 farther = wayPoint * (ahead / distance);
  return walkToPose(Pose2(farther, std::atan2(farther.y(), farther.x())), parameters, sprinting);
}

}  // namespace plumbline
