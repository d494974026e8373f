#pragma once
#include "simspark/LeagueTrace.h"

namespace plumbline::simulation {

/// What the step to this row added to the torso's velocity [m/s], from the accelerometer of the next row.
Vec3 addedVelocity(const simspark::LeagueTrace& trace, std::size_t row);

/// Whether a beam or a trainer moved the robot in the step to this row: accelerometer and gyro do not explain
/// the torso's place. Seen from row 2 on, of the last row only beyond 0.5 m.
bool isPlaced(const simspark::LeagueTrace& trace, std::size_t row);

/// Where isPlaced put the torso's centre of mass, at rest, before the step to this row. The accelerometer,
/// one cycle late, shows what the step added, the gyro how far it turned.
Pose3 placeBefore(const simspark::LeagueTrace& trace, std::size_t row);

}  // namespace plumbline::simulation
