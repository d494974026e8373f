#pragma once
#include <string>

#include "framework/Module.h"
#include "modules/motion/EditedMotion.h"
#include "modules/motion/Motions.h"
#include "motion/KeyframePlayer.h"
#include "motion/Stillness.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/JointData.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/motion/KickMotionOutput.h"
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

/// The kicks with either foot: the motions of motions/ whose files say `kick`, mirrored for the other foot
/// and shifted to where the ball lies.
class KickMotion : public KickMotionBase {
public:
  void init() override;
  void update(KickMotionOutput* theKickMotionOutput) override;

private:
  void read(const RobotModel& robot);
  void start();

  std::vector<motion::KeyframeMotion> kicks_;  ///< the shortest first
  motion::KeyframePlayer player_;
  motion::Stillness stillness_;
  std::string robot_;
  const EditedMotion* edited_ = nullptr;
  unsigned saved_ = 0;  ///< files that an editor had written when the kick was read
};

}  // namespace plumbline
