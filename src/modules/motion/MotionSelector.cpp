#include "modules/motion/MotionSelector.h"

#include <algorithm>

namespace plumbline {

MAKE_MODULE(MotionSelector)

namespace {

constexpr std::size_t indexOf(Motion motion) { return static_cast<std::size_t>(motion); }

}  // namespace

void MotionSelector::init() {
  fadeSeconds_[indexOf(Motion::stand)] = config.get<double>("fadeSeconds.stand", {0, 2});
  fadeSeconds_[indexOf(Motion::walk)] = config.get<double>("fadeSeconds.walk", {0, 2});
  standUpFront_ = config.get<std::string>("standUp.front");
  standUpBack_ = config.get<std::string>("standUp.back");
  standUpSide_ = config.get<std::string>("standUp.side");
  standUpGrace_ = config.get<double>("standUp.graceSeconds", {0, 5});
}

bool MotionSelector::safeToLeave(Motion motion) const {
  switch (motion) {
    case Motion::walk:
      return !theWalkingEngineOutput || theWalkingEngineOutput->standing;
    case Motion::specialAction:
      return !theSpecialActionsOutput || theSpecialActionsOutput->finished;
    case Motion::kick:
      return !theKickMotionOutput || theKickMotionOutput->finished;
    case Motion::stand:
    case Motion::dead:
      break;
  }
  return true;
}

const std::string& MotionSelector::standUpAction() const {
  switch (theFallState->posture) {
    case Posture::onFront:
      return standUpFront_;
    case Posture::onLeft:
    case Posture::onRight:
      return standUpSide_;
    default:
      return standUpBack_;
  }
}

void MotionSelector::start(MotionSelection& selection, Motion motion, const std::string& specialAction) {
  // What begins at the measured joint angles needs no fading, nor does what is only begun again.
  if (motion != selection.motion) {
    fadeFrom_ = selection.ratios;
    fadeTime_ = 0;
  }
  selection.motion = motion;
  selection.specialAction = motion == Motion::specialAction ? specialAction : "";
  selection.started = true;
}

void MotionSelector::fade(MotionSelection& selection) {
  fadeTime_ += theFrameInfo->cycleSeconds;
  const double seconds = fadeSeconds_[indexOf(selection.motion)];
  const double share = fadeTime_ < seconds ? fadeTime_ / seconds : 1;
  for (std::size_t m = 0; m < selection.ratios.size(); ++m)
    selection.ratios[m] = (1 - share) * fadeFrom_[m] + (m == indexOf(selection.motion) ? share : 0);
}

void MotionSelector::update(MotionSelection* theMotionSelection) {
  MotionSelection& selection = *theMotionSelection;
  selection.started = false;
  if (theFrameInfo->restarted) {
    standingUp_ = false;
    grace_ = 0;
    start(selection, Motion::stand, "");
  }
  const bool safe = safeToLeave(selection.motion);
  grace_ = std::max(0.0, grace_ - theFrameInfo->cycleSeconds);
  if (!standingUp_ || safe) {
    // A stand-up ends while the torso still swings up; to begin it anew then would throw the robot over.
    if (standingUp_) grace_ = standUpGrace_;
    standingUp_ = theFallState->lying() && grace_ <= 0;
    if (standingUp_) {
      start(selection, Motion::specialAction, standUpAction());
    } else {
      const Motion wanted = theMotionRequest->motion;
      const bool same =
          wanted == selection.motion &&
          (wanted != Motion::specialAction || selection.specialAction == theMotionRequest->specialAction);
      const bool endsByItself = wanted == Motion::specialAction || wanted == Motion::kick;
      if (safe && (!same || endsByItself)) start(selection, wanted, theMotionRequest->specialAction);
    }
  }
  fade(selection);
}

}  // namespace plumbline
