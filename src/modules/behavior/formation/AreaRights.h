#pragma once
#include <vector>

#include "field/TeamSize.h"
#include "modules/behavior/formation/TeamMember.h"
#include "parameters/Parameter.h"
#include "tactics/OwnArea.h"

namespace plumbline {

struct AreaRightsParameters {
  PARAMETERS(AreaRightsParameters)
  PARAMETER(int, most, 3, "", Range(1, teamSize),
            "players of a team that the rules allow in their own penalty area, the goalie among them")
  PARAMETER(double, there, 0.35, "m", Range(0, 3),
            "who said that it is nearer to the area than this counts as in it: it has gone on since then")
  PARAMETER(double, stays, 1.0, "s", Range(0, 10),
            "by which who is there counts as sooner at the ball than it is")
};

/// Which members may be in the own penalty area, in their order: the goalie, and those that are first at the
/// ball. Whoever lies there keeps its right, because it cannot leave. While others are still there without a
/// right, nobody takes their places: so there are never more than the rules allow. The result depends only on
/// the arguments, not on the order of the members. goalieNumber: whose place is kept free; 0: nobody's.
/// strikerHysteresis: by which the striker counts as sooner at the ball than it is [s].
std::vector<bool> areaRights(const std::vector<TeamMember>& members, const OwnArea& area, int goalieNumber,
                             double strikerHysteresis, const AreaRightsParameters& parameters);

}  // namespace plumbline
