#pragma once
#include "math/Pose2.h"
#include "representations/behavior/PlayerRole.h"

namespace plumbline {

/// A player of the own team as the plan takes it [m, rad, s].
struct TeamMember {
  int number = 0;
  Pose2 pose;
  bool fallen = false;
  int role = 0;  ///< the one it had last, see PlayerRole
  double timeToBall = PlayerRole::never;
};

}  // namespace plumbline
