#include "gap/settings/TracePlay.h"

#include <algorithm>
#include <stdexcept>

#include "framework/StopSignal.h"
#include "simspark/LeagueRobots.h"
#include "simulation/league/MakeWorld.h"
#include "simulation/replay/TraceRowOf.h"

namespace plumbline::gap {

namespace {

using simspark::LeagueTrace;
using simspark::TraceRow;
using simspark::traceStep;

class Player {
public:
  Player(const LeagueTrace& trace, const SimulatorSetup& setup, std::size_t start)
      : trace_(trace), setup_(setup), model_(robotOf(trace)), world_(simulation::makeWorld(setup.world)) {
    for (Link& link : model_.links) {
      link.mass *= setup_.mass;
      link.inertia *= setup_.mass;
    }
    leftFoot_ = model_.linkIndex("lFoot");
    rightFoot_ = model_.linkIndex("rFoot");
    robot_ = world_->addRobot(model_, trace_.rows[start].torso);
    world_->setState(robot_, torsoAt(start), trace_.rows[start].axisAngle, ratesAt(start));
    setBall(start);
  }

  /// The step that makes row i.
  void advance(std::size_t i) {
    StopSignal::throwIfCaught();
    const TraceRow& sent = trace_.rows[i - 1 - static_cast<std::size_t>(setup_.delay)];
    for (const JointId joint : trace_.joints)
      if (model_.has(joint)) world_->setJointVelocity(robot_, joint, setup_.gain * sent.command[joint]);
    for (int step = 0; step < setup_.stepsPerRow; ++step) world_->step();
  }

  /// Back to where the recording is, with the posture that the simulator has.
  void putBack(std::size_t i) {
    world_->moveRobot(robot_, trace_.rows[i].torso);
    world_->setVelocities(robot_, torsoAt(i), ratesAt(i));
    setBall(i);
  }

  TraceRow sense(std::size_t i) const {
    return simulation::traceRowOf(*world_, robot_, leftFoot_, rightFoot_, trace_.rows[i].command);
  }

private:
  // The server integrates positions with the new velocity: differences are exact.
  simulation::BodyState torsoAt(std::size_t i) const {
    const TraceRow &now = trace_.rows[i], &before = trace_.rows[i - 1];
    return {now.torso, (now.torso.translation() - before.torso.translation()) / traceStep,
            now.torso.linear() * now.gyro};
  }

  JointArray ratesAt(std::size_t i) const {
    JointArray rates{};
    for (const JointId joint : trace_.joints)
      rates[joint] = (trace_.rows[i].axisAngle[joint] - trace_.rows[i - 1].axisAngle[joint]) / traceStep;
    return rates;
  }

  void setBall(std::size_t i) {
    world_->setBall(trace_.rows[i].ball, (trace_.rows[i].ball - trace_.rows[i - 1].ball) / traceStep);
  }

  const LeagueTrace& trace_;
  const SimulatorSetup& setup_;
  RobotModel model_;
  std::unique_ptr<simulation::World> world_;
  simulation::RobotHandle robot_ = 0;
  int leftFoot_ = -1, rightFoot_ = -1;
};

}  // namespace

RobotModel robotOf(const LeagueTrace& trace) {
  if (trace.robot)
    throw std::invalid_argument(trace.name + ": has several robots; give recordings of a single robot");
  if (!trace.robotType || *trace.robotType < 0 || *trace.robotType >= numSimsparkTypes())
    throw std::invalid_argument(trace.name + ": the name does not end in a robot's type, _t0 to _t" +
                                std::to_string(numSimsparkTypes() - 1));
  return simsparkRobot(*trace.robotType);
}

std::vector<TraceRow> play(const LeagueTrace& trace, std::size_t first, std::size_t count,
                           const SimulatorSetup& setup) {
  if (first < firstRow || first >= trace.rows.size())
    throw std::out_of_range(trace.name + ": no replay from row " + std::to_string(first));
  const std::size_t start = first - std::min(first - firstRow, leadRows);
  Player player(trace, setup, start);
  for (std::size_t i = start + 1; i <= first; ++i) {
    player.advance(i);
    player.putBack(i);
  }
  std::vector<TraceRow> rows;
  for (std::size_t i = first + 1; i < std::min(first + 1 + count, trace.rows.size()); ++i) {
    player.advance(i);
    rows.push_back(player.sense(i));
  }
  return rows;
}

}  // namespace plumbline::gap
