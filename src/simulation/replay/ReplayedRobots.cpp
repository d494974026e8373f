#include "simulation/replay/ReplayedRobots.h"

#include "simulation/league/MakeWorld.h"
#include "simulation/replay/Placement.h"
#include "simulation/replay/TraceRowOf.h"

namespace plumbline::simulation {

ReplayedRobots::ReplayedRobots(const std::vector<simspark::LeagueTrace>& traces,
                               const std::vector<RobotModel>& models, const std::vector<StartState>& starts,
                               const BodyState& ball, const WorldConfig& config)
    : traces_(traces), models_(models), starts_(starts), world_(makeWorld(config)) {
  for (std::size_t r = 0; r < traces_.size(); ++r)
    robots_.push_back({world_->addRobot(models_[r], starts_[r].torso.pose), models_[r].linkIndex("lFoot"),
                       models_[r].linkIndex("rFoot")});
  makeRow0();
  world_->setBall(ball);
}

/// Load tears gaps into hinges (0.02 mm each), which decide when a foot lands. So the robots stand or lie in
/// the first posture until the hinges have opened. They are awake, because sleep would end that halfway, and
/// then rest until the bodies count as idle, as after a rest on the server. Then the torsos get to their
/// places and the step to row 0 is made: the gaps of a robot that was put into the air close a little in it.
void ReplayedRobots::makeRow0() {
  constexpr int stepsForGaps = 60, stepsToSleep = 15;
  for (std::size_t r = 0; r < robots_.size(); ++r) world_->setPosture(robots_[r].handle, starts_[r].angle);
  for (int i = 0; i < stepsForGaps; ++i) {
    for (std::size_t r = 0; r < robots_.size(); ++r) wake(r);
    world_->step();
  }
  for (std::size_t r = 0; r < robots_.size(); ++r) command(r, JointArray{});
  for (int i = 0; i < stepsToSleep; ++i) world_->step();
  for (std::size_t r = 0; r < robots_.size(); ++r) {
    const StartState& start = starts_[r];
    world_->moveRobot(robots_[r].handle, start.torso.pose);
    world_->setVelocities(robots_[r].handle, start.torso, start.rate);
    if (start.asleep) continue;
    wake(r);
    command(r, start.rate);
  }
  world_->step();
}

void ReplayedRobots::act(std::size_t i) {
  for (std::size_t r = 0; r < robots_.size(); ++r) {
    command(r, i == 1 ? starts_[r].rate : traces_[r].rows[i - 2].command);
    if (isPlaced(traces_[r], i)) world_->moveRobot(robots_[r].handle, placeBefore(traces_[r], i));
  }
}

simspark::TraceRow ReplayedRobots::sense(std::size_t r, std::size_t i) const {
  return traceRowOf(*world_, robots_[r].handle, robots_[r].leftFoot, robots_[r].rightFoot,
                    traces_[r].rows[i].command);
}

void ReplayedRobots::command(std::size_t r, const JointArray& speeds) {
  for (const JointId joint : traces_[r].joints)
    if (models_[r].has(joint)) world_->setJointVelocity(robots_[r].handle, joint, speeds[joint]);
}

/// Only a command that is not zero wakes a robot; the next command takes its place before it has an effect.
void ReplayedRobots::wake(std::size_t r) {
  world_->setJointVelocity(robots_[r].handle, traces_[r].joints.at(0), 1e-7);
}

}  // namespace plumbline::simulation
