#include "modules/simspark/StatusReport.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

namespace plumbline {

MAKE_MODULE(StatusReport)

std::string statusWords(Skill skill, Motion motion, Posture posture, bool searching) {
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
  switch (skill) {
    case Skill::kick:
      return "going to kick";
    case Skill::dribble:
      return "dribbling";
    case Skill::getBall:
      return "going to the ball";
    case Skill::moveToPos:
      return "walking";
    case Skill::none:
    case Skill::stand:
      break;
  }
  return motion == Motion::walk ? "walking" : "standing";
}

void StatusReport::init() { on_ = object<AgentOptions>().status; }

void StatusReport::execute() {
  if (!on_ || theFrameInfo->time < next_) return;
  next_ = std::floor(theFrameInfo->time) + 1;
  const bool searching = !theRobotPose->valid || !theBallPos->valid;
  fmt::print(
      "status {:.2f} robot {:.2f} {:.2f} {:.0f} ball {:.2f} {:.2f} {}\n", theGameState->time,
      theRobotPose->pose.x(), theRobotPose->pose.y(), toDegrees(theRobotPose->pose.heading),
      theBallPos->field.x(), theBallPos->field.y(),
      statusWords(theSkillRequest->skill, theMotionSelection->motion, theFallState->posture, searching));
  std::fflush(stdout);
}

}  // namespace plumbline
