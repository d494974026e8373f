#include "modules/behavior/MotionPlayer.h"

#include "framework/ConfigurationError.h"
#include "modules/motion/Motions.h"

namespace plumbline {

MAKE_MODULE(MotionPlayer)

namespace {
constexpr double rest = 1.5;  ///< between two motions, so that one sees where each begins [s]
}

void MotionPlayer::init() {
  wanted_ = &object<MotionToPlay>();
  const RobotModel* robot = findObject<RobotModel>();
  if (!robot) return;
  const auto motions = readMotions(config, *robot);
  if (!findMotion(motions, wanted_->name))
    throw ConfigurationError("--motion " + wanted_->name + ": " +
                             motion::missingMotion(motions, wanted_->name));
}

bool MotionPlayer::justFinished() const {
  return theMotionSelection && theSpecialActionsOutput &&
         theMotionSelection->motion == Motion::specialAction &&
         theMotionSelection->specialAction == wanted_->name && theSpecialActionsOutput->finished;
}

void MotionPlayer::update(MotionRequest* theMotionRequest) {
  if (theFrameInfo->restarted || theFallState->lying()) {
    playing_ = false;
    stood_ = 0;
  }
  if (playing_ && justFinished()) {
    playing_ = false;
    done_ = true;
    stood_ = 0;
  }
  stood_ += theFrameInfo->cycleSeconds;
  if (!playing_ && stood_ >= rest) {
    if (done_ && wanted_->once)
      requestStop(0, "the motion " + wanted_->name + " was played");
    else
      playing_ = true;
  }
  theMotionRequest->motion = playing_ ? Motion::specialAction : Motion::stand;
  theMotionRequest->specialAction = playing_ ? wanted_->name : "";
}

}  // namespace plumbline
