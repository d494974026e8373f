#include "simulation/replay/StartState.h"

#include <cmath>

#include "simulation/replay/Placement.h"

namespace plumbline::simulation {

namespace {

using simspark::LeagueTrace;
using simspark::TraceRow;
using simspark::traceStep;

// The league's engine turns a body by 2 atan(w dt / 2) in a step, not by w dt: 0.0001 degrees less at 1.5
// rad/s.
double speedOf(double turn) { return 2 * std::tan(turn / 2) / traceStep; }

}  // namespace

StartState startState(const LeagueTrace& trace, const RobotModel& model) {
  const TraceRow &first = trace.rows[0], &second = trace.rows[1];
  StartState start;
  for (const JointId joint : trace.joints) {
    if (!model.has(joint)) continue;
    const double turn = second.axisAngle[joint] - first.axisAngle[joint];
    start.rate[joint] = speedOf(turn);
    start.angle[joint] = first.axisAngle[joint] - turn;
  }
  // The velocity after step 1 is exact; the accelerometer, one cycle late, shows what a step added.
  const Vec3 velocity1 = (second.torso.translation() - first.torso.translation()) / traceStep;
  const Vec3 velocity0 = velocity1 - addedVelocity(trace, 1);
  start.asleep = velocity1 == Vec3::Zero();
  start.torso.pose = first.torso;
  if (start.asleep) return start;
  start.torso.pose.translation() -= traceStep * velocity0;
  start.torso.linearVelocity = velocity0 - addedVelocity(trace, 0);
  const double turn = first.gyro.norm() * traceStep;
  if (turn > 0)
    start.torso.pose.linear() =
        first.torso.linear() * Eigen::AngleAxisd(-turn, first.gyro.normalized()).toRotationMatrix();
  start.torso.angularVelocity = first.torso.linear() * first.gyro;
  return start;
}

}  // namespace plumbline::simulation
