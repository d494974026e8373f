#pragma once
#include <string>
#include <vector>

#include "framework/Module.h"
#include "motion/Keyframes.h"
#include "motion/StandUpChoice.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/modeling/FallState.h"
#include "representations/motion/MotionOutput.h"
#include "representations/motion/MotionRequest.h"
#include "representations/motion/MotionSelection.h"

namespace plumbline {

MODULE(MotionSelector)
  REQUIRES(FrameInfo)
  REQUIRES(RobotDescription)
  REQUIRES(MotionRequest)
  REQUIRES(FallState)
  USES_ALL(MotionOutput)
  PROVIDES(MotionSelection)
  PARAMETER_GROUP(motion::StandUpParameters, standUp, "what a robot does that lies")
END_MODULE

/// Decides which motion drives the joints: the requested one as soon as the previous one can end safely. A
/// lying robot stands up first, whatever is requested, and tries again until it is upright, as StandUpChoice
/// says. It does not if the request says that it stays down, or if there is no motion to stand up with.
class MotionSelector : public MotionSelectorBase {
public:
  void init() override;
  void update(MotionSelection* theMotionSelection) override;

private:
  /// The motion's output, null if there is no such motion.
  const MotionOutput* output(const std::string& motion) const;
  /// A robot that sits stands up as from its back.
  motion::LyingOn lyingOn() const;
  void learnMotions(const std::string& robot, const std::vector<motion::KeyframeMotion>& motions);
  void start(MotionSelection& selection, const std::string& motion, const std::string& specialAction);
  void fade(MotionSelection& selection);

  std::vector<double> fadeFrom_;  ///< ratios when the fade began
  double fadeTime_ = 0;           ///< since the fade began [s]
  bool standingUp_ = false;
  double grace_ = 0;  ///< what is left of standUp.graceSeconds [s]
  double again_ = 0;  ///< what is left of standUp.againSeconds [s]
  motion::StandUpChoice choice_;
  std::string robot_;    ///< whose motions the choice knows
  std::string unknown_;  ///< the last requested motion that does not exist
};

}  // namespace plumbline
