#include "modules/motion/MotionSelector.h"

#include <algorithm>
#include <utility>

#include "modules/motion/Motions.h"

namespace plumbline {

MAKE_MODULE(MotionSelector)

void MotionSelector::init() {
  // Where main knows the robot, an unknown name is reported before anything else starts.
  const RobotModel* robot = findObject<RobotModel>();
  if (!robot) return;
  const auto motions = readMotions(config, *robot);
  if (const auto missing = motion::missingStandUp(standUp, motions))
    config.refuse("standUp." + missing->parameter, missing->problem);
  learnMotions(robot->name, motions);
}

void MotionSelector::learnMotions(const std::string& robot,
                                  const std::vector<motion::KeyframeMotion>& motions) {
  robot_ = robot;
  choice_.learn(standUp, motions);
}

const MotionOutput* MotionSelector::output(const std::string& motion) const {
  for (const MotionOutput* output : allMotionOutputs)
    if (output->motion == motion) return output;
  return nullptr;
}

motion::LyingOn MotionSelector::lyingOn() const {
  switch (theFallState->posture) {
    case Posture::onFront:
      return motion::LyingOn::front;
    case Posture::onLeft:
    case Posture::onRight:
      return motion::LyingOn::side;
    default:
      return motion::LyingOn::back;
  }
}

void MotionSelector::start(MotionSelection& selection, const std::string& motion,
                           const std::string& specialAction) {
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
  const MotionOutput* selected = output(selection.motion);
  const double seconds = selected ? selected->fadeSeconds : 0;
  const double share = fadeTime_ < seconds ? fadeTime_ / seconds : 1;
  for (std::size_t m = 0; m < selection.ratios.size(); ++m)
    selection.ratios[m] = (1 - share) * fadeFrom_[m] + (selection.motions[m] == selection.motion ? share : 0);
}

void MotionSelector::update(MotionSelection* theMotionSelection) {
  MotionSelection& selection = *theMotionSelection;
  selection.started = false;
  if (selection.motions.size() != allMotionOutputs.size()) {
    selection.motions.clear();
    for (const MotionOutput* output : allMotionOutputs) selection.motions.push_back(output->motion);
    selection.ratios.assign(selection.motions.size(), 0);
    for (std::size_t m = 0; m < selection.motions.size(); ++m)
      selection.ratios[m] = selection.motions[m] == selection.motion;
    fadeFrom_ = selection.ratios;
  }
  if (theRobotDescription->known() && theRobotDescription->name != robot_)
    learnMotions(theRobotDescription->name, readMotions(config, theRobotDescription->model));
  if (theFrameInfo->restarted) {
    standingUp_ = false;
    grace_ = again_ = 0;
    choice_.forget();
    start(selection, Motion::stand, "");
  }
  const MotionOutput* current = output(selection.motion);
  const bool safe = !current || current->finished;
  grace_ = std::max(0.0, grace_ - theFrameInfo->cycleSeconds);
  again_ = std::max(0.0, again_ - theFrameInfo->cycleSeconds);
  if (!standingUp_ || safe) {
    // A stand-up ends while the torso still swings up; to begin it anew then would throw the robot over.
    // After a roll nothing swings.
    if (standingUp_) {
      grace_ = choice_.rolled() ? 0 : standUp.graceSeconds;
      again_ = standUp.againSeconds;
    }
    standingUp_ = theFallState->lying() && grace_ <= 0 && !theMotionRequest->staysDown &&
                  motion::standsUpFrom(standUp, lyingOn());
    if (standingUp_) {
      start(selection, Motion::specialAction, choice_.next(standUp, lyingOn(), again_ > 0));
    } else {
      const MotionOutput* next = output(theMotionRequest->motion);
      if (!next && unknown_ != theMotionRequest->motion)
        log.error() << "no module of modules.cfg provides the motion \"" << theMotionRequest->motion
                    << "\": the robot stands";
      unknown_ = next ? "" : theMotionRequest->motion;
      const std::string wanted = next ? next->motion : Motion::stand;
      const bool same =
          wanted == selection.motion &&
          (wanted != Motion::specialAction || selection.specialAction == theMotionRequest->specialAction);
      const bool leaves = safe || (theMotionRequest->atOnce && selection.motion == Motion::walk);
      if (leaves && (!same || (next && next->endsByItself)))
        start(selection, wanted, theMotionRequest->specialAction);
    }
  }
  fade(selection);
}

}  // namespace plumbline
