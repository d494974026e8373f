#pragma once
#include "framework/Module.h"
#include "modules/motion/Motions.h"
#include "motion/KeyframePlayer.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/JointData.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/motion/MotionOutputs.h"
#include "representations/motion/MotionRequest.h"
#include "representations/motion/MotionSelection.h"

namespace plumbline {

MODULE(KickMotion)
REQUIRES(FrameInfo)
REQUIRES(RobotDescription)
REQUIRES(MotionRequest)
REQUIRES(MotionSelection)
REQUIRES(JointData)
REQUIRES(SensorData)
PROVIDES(KickMotionOutput)
END_MODULE

/// The quick kick with either foot: keyframes for the right foot, shifted to where the ball lies.
class KickMotion : public KickMotionBase {
public:
  void init() override;
  void update(KickMotionOutput* theKickMotionOutput) override;

private:
  void read(const RobotModel& robot);

  std::string name_;
  motion::KeyframeMotion right_, left_;
  motion::KeyframePlayer player_;
  Stillness stillness_;
  int type_ = -1;
};

}  // namespace plumbline
