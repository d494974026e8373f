#include "modules/infrastructure/StatusReport.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "modules/behavior/MotionPlayer.h"

namespace plumbline {

MAKE_MODULE(StatusReport)

std::string statusWords(const std::string& doing, const std::string& motion, Posture posture,
                        bool searching) {
  if (posture == Posture::falling) return "falling";
  if (motion == Motion::specialAction || (posture != Posture::upright && posture != Posture::sitting)) {
    switch (posture) {
      case Posture::onFront:
        return "getting up from the front";
      case Posture::onBack:
        return "getting up from the back";
      case Posture::onLeft:
      case Posture::onRight:
        return "getting up from the side";
      default:
        return "getting up";
    }
  }
  if (motion == Motion::kick) return "kicking";
  if (searching && motion == Motion::walk) return "searching";
  if (!doing.empty()) return doing;
  return motion == Motion::walk ? "walking" : "standing";
}

void StatusReport::init() {
  wanted_ = object<StatusOptions>().wanted;
  if (const MotionToPlay* motion = findObject<MotionToPlay>()) played_ = motion->name;
}

std::string StatusReport::doing() const {
  for (const SkillOutput* output : allSkillOutputs)
    if (output->skill == theSkillRequest->skill) return output->doing;
  return "";
}

void StatusReport::execute() {
  if (!wanted_ || theFrameInfo->time < next_) return;
  // Nothing has been heard of the game yet.
  if (theGameState->playMode == PlayMode::unknown && theFrameInfo->time == 0) return;
  next_ = std::floor(theFrameInfo->time) + 1;
  const bool searching = !theRobotPose->valid || !theBallPos->valid;
  const MotionSelection& selection = *theMotionSelection;
  const bool plays = !played_.empty() && selection.specialAction == played_;
  fmt::print("status {:.2f} robot {:.2f} {:.2f} {:.0f} ball {:.2f} {:.2f} {}\n", theGameState->time,
             theRobotPose->pose.x(), theRobotPose->pose.y(), toDegrees(theRobotPose->pose.heading),
             theBallPos->field.x(), theBallPos->field.y(),
             plays ? "playing " + played_
                   : statusWords(doing(), selection.motion, theFallState->posture, searching));
  std::fflush(stdout);
}

}  // namespace plumbline
