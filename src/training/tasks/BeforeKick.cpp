#include "training/tasks/BeforeKick.h"

namespace plumbline::training {
namespace {

constexpr double walkedUp = 0.6;  // share of the runs that begin with a walk
constexpr int mostCyclesToStop = 100;
constexpr double fallsOver = 0.5;  // tilt of the torso from which it does not come to a kick [rad]

/// Walks somewhere near forward and stops, as before a kick in a game. False: fell or does not stop.
bool walkUp(MotionDriver& robot) {
  const Vec2 velocity(robot.random(-0.05, 0.35), robot.random(-0.1, 0.1));
  const double turn = robot.random(-0.4, 0.4), seconds = robot.random(0.8, 1.6);
  double time = 0;
  while (time < seconds) {
    robot.walkStep((1 - 0.7 * time / seconds) * velocity, turn);
    time += MotionDriver::dt;
  }
  for (int i = 0; i < mostCyclesToStop; ++i)
    if (robot.walkStep(Vec2::Zero(), 0, false).standing) return !robot.lying() && robot.tilt() < fallsOver;
  return false;
}

/// Stands and comes to rest from a lean of up to two degrees.
bool sway(MotionDriver& robot) {
  JointArray leaning = robot.stand;
  const double roll = robot.random(-0.035, 0.035), pitch = robot.random(-0.035, 0.035);
  for (const JointId joint : {lHipRoll, rHipRoll}) leaning[joint] += roll;
  for (const JointId joint : {lAnkleRoll, rAnkleRoll}) leaning[joint] -= roll;
  for (const JointId joint : {lAnklePitch, rAnklePitch}) leaning[joint] += pitch;
  const int rest = 3 + static_cast<int>(robot.random(0, 8));
  for (int i = 0; i < 5; ++i) robot.step(leaning);
  for (int i = 0; i < rest; ++i) robot.step(robot.stand);
  return robot.tilt() < fallsOver;
}

}  // namespace

bool comesToKick(MotionDriver& robot) { return robot.random(0, 1) < walkedUp ? walkUp(robot) : sway(robot); }

}  // namespace plumbline::training
