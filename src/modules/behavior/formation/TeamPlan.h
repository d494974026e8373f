#pragma once
#include <vector>

#include "field/TeamSize.h"
#include "math/Pose2.h"
#include "modules/behavior/formation/FormationTable.h"
#include "modules/behavior/formation/TimeToBall.h"
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

/// The role of each member, in the order of the members, see PlayerRole.
struct TeamPlan {
  std::vector<int> roles;
  int strikerNumber = 0;
};

struct TeamPlanParameters {
  PARAMETERS(TeamPlanParameters)
  PARAMETER(int, goalieNumber, 1, "", Range(0, teamSize), "number of the goalie; 0: none")
  PARAMETER(double, strikerHysteresis, 0.8, "s", Range(0, 10),
            "another one must be at the ball sooner by this to become the striker")
  PARAMETER(double, goalieWaits, 0.5, "s", Range(0, 10),
            "the goalie must be at the ball sooner by this than any other to leave the goal for it")
  PARAMETER(double, goalieReach, 3.5, "m", Range(0, 30),
            "the goalie leaves the goal for balls this near to it")
  PARAMETER(double, placeHysteresis, 1.0, "s", Range(0, 10),
            "by which a supporter's own place counts as nearer than it is")
  PARAMETER(double, supporterSpeed, 0.7, "m/s", Range(0.05, 3), "of players on their way to their places")
};

/// The striker is the player that reaches the ball first. There is one goalie. The others take the first
/// places of the table at the least total time. The result depends only on the arguments, not on the order of
/// members, so players with the same data decide the same. places: of all supporters, for this ball.
TeamPlan planTeam(std::vector<TeamMember> members, const Vec2& ball, const Vec2& ownGoal,
                  const std::vector<Vec2>& places, const TimeToBallParameters& time,
                  const TeamPlanParameters& parameters);

}  // namespace plumbline
