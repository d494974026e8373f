#include "simulation/replay/Replay.h"

#include "simulation/Field.h"
#include "simulation/replay/BallStart.h"
#include "simulation/replay/TraceRowOf.h"

namespace plumbline::simulation {

namespace {

using simspark::LeagueTrace;
using simspark::TraceRow;
using simspark::traceStep;

class TracePlayer {
public:
  TracePlayer(const LeagueTrace& trace_, const RobotModel& model_, const WorldConfig& config_)
      : trace(trace_), model(model_), config(config_), world(makeWorld(config_)) {
    handle = world->addRobot(model, trace.rows[0].torso);
    leftFoot = model.linkIndex("lFoot");
    rightFoot = model.linkIndex("rFoot");
  }

  std::vector<TraceRow> play() {
    setFirstState();
    std::vector<TraceRow> rows = {sense(0)};
    for (std::size_t i = 1; i < trace.rows.size(); ++i) {
      command(i == 1 ? firstSpeeds() : trace.rows[i - 2].command);
      if (ballJumps(trace, i)) world->setBall(ballBefore(trace, i, config));
      world->step();
      rows.push_back(sense(i));
    }
    return rows;
  }

private:
  /// The velocities the motors had in the step to row 1.
  JointArray firstSpeeds() const {
    JointArray speeds{};
    for (const JointId joint : trace.joints)
      speeds[joint] = (trace.rows[1].axisAngle[joint] - trace.rows[0].axisAngle[joint]) / traceStep;
    return speeds;
  }

  void setFirstState() {
    const TraceRow &first = trace.rows[0], &second = trace.rows[1];
    BodyState torso;
    torso.pose = first.torso;
    // The velocity after step 1 is exact; the accelerometer, one cycle late, tells what step 1 added.
    const Vec3 velocity1 = (second.torso.translation() - first.torso.translation()) / traceStep;
    const Vec3 added = second.torso.linear() * trace.rows[2].acc - Vec3(0, 0, gravity);
    torso.linearVelocity = velocity1 - traceStep * added;
    torso.angularVelocity = first.torso.linear() * first.gyro;
    settle(first);
    world->setVelocities(handle, torso, firstSpeeds());
    if (velocity1 != Vec3::Zero()) wake();
    world->setBall(ballAfterOneStep(ballBefore(trace, 0, config), config));
  }

  /// Stands or lies in the first posture until load has torn its gaps into the hinges (0.02 mm each) and the
  /// bodies count as idle, as they do after a rest on the server; then moves the torso to its place.
  void settle(const TraceRow& first) {
    world->setPosture(handle, first.axisAngle);
    for (int i = 0; i < 25; ++i) world->step();
    world->moveRobot(handle, first.torso);
  }

  /// Only a command that is not zero wakes a robot; the next command takes its place before it has an effect.
  void wake() { world->setJointVelocity(handle, trace.joints.at(0), 1e-7); }

  void command(const JointArray& speeds) {
    for (const JointId joint : trace.joints)
      if (model.has(joint)) world->setJointVelocity(handle, joint, speeds[joint]);
  }

  TraceRow sense(std::size_t i) const {
    return traceRowOf(*world, handle, leftFoot, rightFoot, trace.rows[i].command);
  }

  const LeagueTrace& trace;
  const RobotModel& model;
  WorldConfig config;
  std::unique_ptr<World> world;
  RobotHandle handle = 0;
  int leftFoot = -1, rightFoot = -1;
};

}  // namespace

std::vector<TraceRow> replay(const LeagueTrace& trace, const RobotModel& model, const WorldConfig& config) {
  return TracePlayer(trace, model, config).play();
}

}  // namespace plumbline::simulation
