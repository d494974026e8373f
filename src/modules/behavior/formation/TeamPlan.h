#pragma once
#include <vector>

#include "field/TeamSize.h"
#include "math/Pose2.h"
#include "modules/behavior/formation/AreaRights.h"
#include "modules/behavior/formation/FormationTable.h"
#include "modules/behavior/formation/TeamMember.h"
#include "modules/behavior/formation/TimeToBall.h"
#include "representations/behavior/PlayerRole.h"

namespace plumbline {

/// The role of each member, in the order of the members, see PlayerRole, and whether it may be in the own
/// penalty area.
struct TeamPlan {
  std::vector<int> roles;
  std::vector<bool> rights;
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
  PARAMETER_GROUP(AreaRightsParameters, area, "who may be in the own penalty area")
  PARAMETER(double, areaReach, 0.6, "m", Range(0, 5),
            "who goes to a ball that is nearer to the own penalty area than this must have that right")
  PARAMETER(double, supporterSpeed, 0.7, "m/s", Range(0.05, 3), "of players on their way to their places")
};

/// The striker is the player that reaches the ball first, of those that may go there. There is one goalie.
/// The others take the first places of the table at the least total time. The result depends only on the
/// arguments, not on the order of members, so players with the same data decide the same. places: of all
/// supporters, for this ball.
TeamPlan planTeam(std::vector<TeamMember> members, const Vec2& ball, const FieldSize& field,
                  const std::vector<Vec2>& places, const TimeToBallParameters& time,
                  const TeamPlanParameters& parameters);

}  // namespace plumbline
