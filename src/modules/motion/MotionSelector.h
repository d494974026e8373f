#pragma once
#include <string>
#include <vector>

#include "framework/Module.h"
#include "motion/Keyframes.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/modeling/FallState.h"
#include "representations/motion/MotionOutput.h"
#include "representations/motion/MotionRequest.h"
#include "representations/motion/MotionSelection.h"

namespace plumbline {

struct StandUpParameters {
  PARAMETERS(StandUpParameters)
  PARAMETER(std::string, front, "standUpFront", "", Range(),
            "motion of motions/ for a robot that lies on its front")
  PARAMETER(std::string, back, "standUpBack", "", Range(), "for one on its back")
  PARAMETER(std::string, side, "rollOver", "", Range(), "for one on its side")
  PARAMETER(std::string, fastFront, "", "", Range(),
            "the first try in place of `front`, as standUpFrontFast; empty: none")
  PARAMETER(std::string, fastBack, "", "", Range(),
            "the first try in place of `back`, as standUpBackFast; empty: none")
  PARAMETER(double, againSeconds, 4, "s", Range(0, 60),
            "if a robot lies again within this time after standing up, that try failed, and the next one is "
            "the other motion")
  PARAMETER(double, graceSeconds, 0.5, "s", Range(0, 5),
            "time until the next try, since a stand-up ends while the torso still swings up")
};

MODULE(MotionSelector)
  REQUIRES(FrameInfo)
  REQUIRES(RobotDescription)
  REQUIRES(MotionRequest)
  REQUIRES(FallState)
  USES_ALL(MotionOutput)
  PROVIDES(MotionSelection)
  PARAMETER_GROUP(StandUpParameters, standUp, "what a robot does that lies")
END_MODULE

/// Decides which motion drives the joints: the requested one as soon as the previous one can end safely. A
/// lying robot stands up first, whatever is requested, and tries again until it is upright. The first try
/// uses a fast motion, if there is one, the next one the other motion, and so on in turn.
class MotionSelector : public MotionSelectorBase {
public:
  void init() override;
  void update(MotionSelection* theMotionSelection) override;

private:
  /// The motion's output, null if there is no such motion.
  const MotionOutput* output(const std::string& motion) const;
  /// The special action that stands up from how the robot lies.
  const std::string& standUpAction() const;
  void learnMotions(const std::string& robot, const std::vector<motion::KeyframeMotion>& motions);
  void start(MotionSelection& selection, const std::string& motion, const std::string& specialAction);
  void fade(MotionSelection& selection);

  std::vector<double> fadeFrom_;  ///< ratios when the fade began
  double fadeTime_ = 0;           ///< since the fade began [s]
  bool standingUp_ = false;
  double grace_ = 0;                           ///< what is left of standUp.graceSeconds [s]
  double again_ = 0;                           ///< what is left of standUp.againSeconds [s]
  int failed_ = 0;                             ///< stand-ups in a row that did not keep it on its feet
  std::string robot_;                          ///< whose motions these are
  bool fastFront_ = false, fastBack_ = false;  ///< it has them
  std::string unknown_;                        ///< the last requested motion that does not exist
};

}  // namespace plumbline
