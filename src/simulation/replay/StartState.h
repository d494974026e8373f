#pragma once
#include "robot/RobotModel.h"
#include "simspark/LeagueTrace.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

/// A robot one step before a trace's first row, as far as the trace shows.
struct StartState {
  BodyState torso;     ///< of its centre of mass
  JointArray angle{};  ///< [rad]
  JointArray rate{};   ///< of the steps to rows 0 and 1 [rad/s]
  bool asleep = false;
};

/// From the trace's first three rows.
StartState startState(const simspark::LeagueTrace& trace, const RobotModel& model);

}  // namespace plumbline::simulation
