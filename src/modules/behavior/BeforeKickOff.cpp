#include "modules/behavior/BeforeKickOff.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

MAKE_MODULE(BeforeKickOff)

void BeforeKickOff::parametersChanged() {
  if (x.empty() || y.size() != x.size() || heading.size() != x.size())
    refuse("x", "must have one entry per player, and as many as y and heading");
  if (teamX.empty() || teamY.size() != teamX.size())
    refuse("teamX", "must have one entry per player, and as many as teamY");
}

bool BeforeKickOff::ownKickOff() const {
  if (theGameState->playMode != TeamPlayMode::beforeKickOff)
    return theGameState->playMode == TeamPlayMode::goalOpponent;
  // The left team begins the game, the other one the second half.
  return thePlayerInfo->leftSide == (theGameState->time < 1);
}

Pose2 BeforeKickOff::place() const {
  const auto player = static_cast<std::size_t>(std::max(thePlayerInfo->number, 1) - 1);
  if (!thePlayerRole || thePlayerRole->members < 2) {
    const std::size_t i = player % x.size();
    return {x[i], y[i], heading[i]};
  }
  Vec2 place(teamX[player % teamX.size()], teamY[player % teamX.size()]);
  if (!ownKickOff() && place.norm() < ringDistance)
    place = place.norm() > 0 ? Vec2(place.normalized() * ringDistance) : Vec2(-ringDistance, 0);
  return {place.x(), place.y(), std::atan2(-place.y(), -place.x())};
}

void BeforeKickOff::update(BeforeKickOffOutput* theBeforeKickOffOutput) {
  BehaviorOutput& output = *theBeforeKickOffOutput;
  output.clear();
  const TeamPlayMode mode = theGameState->playMode;
  output.active = mode == TeamPlayMode::beforeKickOff || mode == TeamPlayMode::goalOwn ||
                  mode == TeamPlayMode::goalOpponent;
  const Pose2 wanted = place();
  // Again when the first mate was heard, and with it the place has changed.
  if (output.active && (!waiting_ || theFrameInfo->restarted || wanted.position != beamed_))
    since_ = theFrameInfo->time;
  waiting_ = output.active;
  beamed_ = wanted.position;
  if (!output.active) return;
  output.skill = Skill::stand;
  if (theFrameInfo->time - since_ > beamSeconds || theGameState->playMode == TeamPlayMode::unknown) return;
  output.beam = true;
  output.beamPose = wanted;
}

}  // namespace plumbline
