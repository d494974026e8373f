#pragma once
#include <memory>
#include <optional>

#include "framework/Module.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/JointData.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/modeling/TorsoAngles.h"
#include "representations/motion/MotionOutputs.h"
#include "representations/motion/MotionRequest.h"
#include "representations/motion/MotionSelection.h"
#include "walking/BackgroundFit.h"
#include "walking/WalkEngine.h"

namespace plumbline {

MODULE(WalkingEngine)
REQUIRES(FrameInfo)
REQUIRES(RobotDescription)
REQUIRES(MotionRequest)
REQUIRES(MotionSelection)
REQUIRES(JointData)
REQUIRES(SensorData)
REQUIRES(TorsoAngles)
PROVIDES(WalkingEngineOutput)
END_MODULE

/// While it walks, the model may be fitted to the robot (config/WalkingEngine.yaml, fit).
/// Walks while the walk is selected; once another motion is requested it comes to a stop and stands, which
/// allows the selector to leave it. While another motion moves the robot its output is the stand.
class WalkingEngine : public WalkingEngineBase {
public:
  void init() override;
  void update(WalkingEngineOutput* theWalkingEngineOutput) override;

private:
  void fitModel();

  walking::WalkGaits gaits_;
  std::optional<walking::WalkEngine> engine_;
  std::unique_ptr<walking::BackgroundFit> fit_;
  bool fitsPlan_ = false;
  int type_ = -1;
  bool standing_ = true;  ///< the walk did when it was last selected
};

}  // namespace plumbline
