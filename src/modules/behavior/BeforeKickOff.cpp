#include "modules/behavior/BeforeKickOff.h"

#include <algorithm>

namespace plumbline {

MAKE_MODULE(BeforeKickOff)

void BeforeKickOff::init() {
  x_ = config.get<std::vector<double>>("x");
  y_ = config.get<std::vector<double>>("y");
  heading_ = config.get<std::vector<double>>("heading");
  if (x_.empty() || y_.size() != x_.size() || heading_.size() != x_.size())
    config.fail("x", "x, y and heading need one entry per player each");
  beamSeconds_ = config.get<double>("beamSeconds", {0.02, 10.0});
}

void BeforeKickOff::update(BeforeKickOffOutput* theBeforeKickOffOutput) {
  BehaviorOutput& output = theBeforeKickOffOutput->output;
  output = {};
  const PlayMode mode = theGameState->playMode;
  output.active =
      mode == PlayMode::beforeKickOff || mode == PlayMode::goalOwn || mode == PlayMode::goalOpponent;
  if (output.active && (!waiting_ || theFrameInfo->restarted)) since_ = theFrameInfo->time;
  waiting_ = output.active;
  if (!output.active) return;
  output.skill = Skill::stand;
  if (theFrameInfo->time - since_ > beamSeconds_ || theGameState->playMode == PlayMode::unknown) return;
  const auto player = static_cast<std::size_t>(std::max(thePlayerInfo->number, 1) - 1) % x_.size();
  output.beam = true;
  output.beamPose = Pose2(x_[player], y_[player], heading_[player]);
}

}  // namespace plumbline
