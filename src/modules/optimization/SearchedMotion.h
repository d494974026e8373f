#pragma once
#include <memory>
#include <string>
#include <vector>

#include "framework/Module.h"
#include "modules/motion/Motions.h"
#include "modules/optimization/AgentTask.h"
#include "motion/KeyframePlayer.h"
#include "motion/Stillness.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/JointData.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/motion/MotionSelection.h"
#include "representations/optimization/OptimizationTrial.h"
#include "representations/optimization/SearchedMotionOutput.h"

namespace plumbline {

MODULE(SearchedMotion)
  REQUIRES(FrameInfo)
  REQUIRES(RobotDescription)
  REQUIRES(OptimizationTrial)
  REQUIRES(MotionSelection)
  REQUIRES(JointData)
  REQUIRES(SensorData)
  PROVIDES(SearchedMotionOutput)
END_MODULE

/// Plays the motion of the trial that is open: its motion with the numbers that the optimiser asks for.
class SearchedMotion : public SearchedMotionBase {
public:
  void update(SearchedMotionOutput* theSearchedMotionOutput) override;

private:
  void take();

  std::unique_ptr<AgentTask> task_;
  std::string begunTask_;  ///< that task_ is made of
  std::vector<std::string> begunOptions_;
  motion::KeyframeMotion motion_;
  motion::KeyframePlayer player_;
  motion::Stillness stillness_;
  std::int64_t number_ = -1;
};

}  // namespace plumbline
