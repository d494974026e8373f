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
#include "representations/motion/MotionSelection.h"
#include "representations/motion/SpecialActionsOutput.h"

namespace plumbline {

MODULE(SpecialActions)
  REQUIRES(FrameInfo)
  REQUIRES(RobotDescription)
  REQUIRES(MotionSelection)
  REQUIRES(JointData)
  REQUIRES(SensorData)
  PROVIDES(SpecialActionsOutput)
END_MODULE

/// Plays the keyframe motion that is selected, from the joint angles at its start.
class SpecialActions : public SpecialActionsBase {
public:
  void init() override;
  void update(SpecialActionsOutput* theSpecialActionsOutput) override;

private:
  void read(const RobotModel& robot);
  void start();

  std::vector<motion::KeyframeMotion> motions_;
  motion::KeyframePlayer player_;
  motion::Stillness stillness_;
  std::string robot_;
  const EditedMotion* edited_ = nullptr;
  unsigned saved_ = 0;  ///< files that an editor had written when the motions were read
};

}  // namespace plumbline
