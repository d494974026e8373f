#include "modules/behavior/BeforeKickOff.h"

#include <algorithm>

namespace plumbline {

MAKE_MODULE(BeforeKickOff)

void BeforeKickOff::parametersChanged() {
  if (x.empty() || y.size() != x.size() || heading.size() != x.size())
    refuse("x", "must have one entry per player, and as many as y and heading");
}

void BeforeKickOff::update(BeforeKickOffOutput* theBeforeKickOffOutput) {
  BehaviorOutput& output = *theBeforeKickOffOutput;
  output.clear();
  const PlayMode mode = theGameState->playMode;
  output.active =
      mode == PlayMode::beforeKickOff || mode == PlayMode::goalOwn || mode == PlayMode::goalOpponent;
  if (output.active && (!waiting_ || theFrameInfo->restarted)) since_ = theFrameInfo->time;
  waiting_ = output.active;
  if (!output.active) return;
  output.skill = Skill::stand;
  if (theFrameInfo->time - since_ > beamSeconds || theGameState->playMode == PlayMode::unknown) return;
  const auto player = static_cast<std::size_t>(std::max(thePlayerInfo->number, 1) - 1) % x.size();
  output.beam = true;
  output.beamPose = Pose2(x[player], y[player], heading[player]);
}

}  // namespace plumbline
