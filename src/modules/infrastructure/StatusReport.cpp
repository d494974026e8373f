#include "modules/infrastructure/StatusReport.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "modules/behavior/MotionPlayer.h"

namespace plumbline {

MAKE_MODULE(StatusReport)

std::string statusWords(const SkillOutput* skill, const MotionOutput* motion, Posture posture,
                        bool searching) {
  switch (posture) {
    case Posture::falling:
      return "falling";
    case Posture::onFront:
      return "getting up from the front";
    case Posture::onBack:
      return "getting up from the back";
    case Posture::onLeft:
    case Posture::onRight:
      return "getting up from the side";
    default:
      break;
  }
  if (motion && motion->endsByItself) return motion->doing;
  if (searching && motion && motion->goes) return "searching";
  if (skill) return skill->doing;
  return motion ? motion->doing : "standing";
}

void StatusReport::init() {
  wanted_ = object<StatusOptions>().wanted;
  if (const MotionToPlay* motion = findObject<MotionToPlay>()) played_ = motion->name;
}

const MotionOutput* StatusReport::motion() const {
  const auto found = std::ranges::find(allMotionOutputs, theMotionSelection->motion, &MotionOutput::motion);
  return found == allMotionOutputs.end() ? nullptr : *found;
}

void StatusReport::execute() {
  if (!wanted_ || theFrameInfo->time < next_) return;
  // Nothing has been heard of the game yet.
  if (theGameState->playMode == TeamPlayMode::unknown && theFrameInfo->time == 0) return;
  next_ = std::floor(theFrameInfo->time) + 1;
  const bool searching = !theRobotPose->valid || !theBallPos->valid;
  const MotionSelection& selection = *theMotionSelection;
  const bool plays = !played_.empty() && selection.specialAction == played_;
  fmt::print("status {:.2f} robot {:.2f} {:.2f} {:.0f} ball {:.2f} {:.2f} {}\n", theGameState->time,
             theRobotPose->pose.x(), theRobotPose->pose.y(), toDegrees(theRobotPose->pose.heading),
             theBallPos->field.x(), theBallPos->field.y(),
             plays ? "playing " + played_
                   : statusWords(findSkill(allSkillOutputs, theSkillRequest->skill), motion(),
                                 theFallState->posture, searching));
  std::fflush(stdout);
}

}  // namespace plumbline
