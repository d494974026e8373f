#pragma once
#include <memory>
#include <vector>

#include "simulation/replay/StartState.h"

namespace plumbline::simulation {

/// The robots of a recording in a world of their own, repeated open loop.
class ReplayedRobots {
public:
  /// `ball`: its state in row 0. The lists must outlive it and are of one length. The world is then at row 0.
  ReplayedRobots(const std::vector<simspark::LeagueTrace>& traces, const std::vector<RobotModel>& models,
                 const std::vector<StartState>& starts, const BodyState& ball, const WorldConfig& config);

  /// Gives the robots what acts in the step to row i: commands, and a place where somebody put them.
  void act(std::size_t i);
  /// What a recording would say of robot r now, which is row i.
  simspark::TraceRow sense(std::size_t r, std::size_t i) const;
  World& world() { return *world_; }

private:
  struct Robot {
    RobotHandle handle;
    int leftFoot, rightFoot;
  };

  void makeRow0();
  void command(std::size_t r, const JointArray& speeds);
  void wake(std::size_t r);

  const std::vector<simspark::LeagueTrace>& traces_;
  const std::vector<RobotModel>& models_;
  const std::vector<StartState>& starts_;
  std::unique_ptr<World> world_;
  std::vector<Robot> robots_;
};

}  // namespace plumbline::simulation
