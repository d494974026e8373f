#include "simulation/replay/TraceRowOf.h"

namespace plumbline::simulation {

namespace {

std::optional<simspark::ForceReading> toTrace(const std::optional<FootForce>& force) {
  if (!force) return std::nullopt;
  return simspark::ForceReading{force->point, force->force};
}

}  // namespace

simspark::TraceRow traceRowOf(const World& world, RobotHandle robot, int leftFoot, int rightFoot,
                              const JointArray& command) {
  const RobotReadings& readings = world.readings(robot);
  simspark::TraceRow row;
  row.command = command;
  row.angle = row.axisAngle = readings.angle;
  row.gyro = readings.gyro;
  row.acc = readings.acc;
  row.leftFootForce = toTrace(readings.leftFoot);
  row.rightFootForce = toTrace(readings.rightFoot);
  row.leftToeForce = toTrace(readings.leftToe);
  row.rightToeForce = toTrace(readings.rightToe);
  row.torso = world.linkState(robot, 0).pose;
  row.leftFoot = world.linkState(robot, leftFoot).pose;
  row.rightFoot = world.linkState(robot, rightFoot).pose;
  row.ball = world.ball().pose.translation();
  return row;
}

}  // namespace plumbline::simulation
