#pragma once
#include "simspark/LeagueTrace.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

/// The row of a recording for a robot in the world now; leftFoot, rightFoot: its model's links.
simspark::TraceRow traceRowOf(const World& world, RobotHandle robot, int leftFoot, int rightFoot,
                              const JointArray& command);

}  // namespace plumbline::simulation
