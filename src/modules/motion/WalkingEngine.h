#pragma once
#include <memory>
#include <optional>
#include <string>

#include "framework/Module.h"
#include "motion/MotionDefaults.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/JointData.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/modeling/TorsoAngles.h"
#include "representations/motion/MotionRequest.h"
#include "representations/motion/MotionSelection.h"
#include "representations/motion/WalkingEngineOutput.h"
#include "walking/engine/WalkEngine.h"
#include "walking/estimation/BackgroundFit.h"

namespace plumbline {

/// The fit of the walk's model to the robot while it walks (section 4.3.2); read at the start.
struct WalkFitParameters {
  PARAMETERS(WalkFitParameters)
  PARAMETER(bool, enabled, false, "", Range(), "the model is fitted")
  PARAMETER(
      bool, plan, false, "", Range(),
      "plans steps with the fitted model as far as that is safe; otherwise the model only predicts the robot")
  PARAMETER(int, steps, 60, "", Range(6, 10000), "steps observed before a fit begins")
  PARAMETER(double, seconds, 20, "s", Range(0.1, 3600),
            "walking time from the begin of a fit to the use of its result")
  PARAMETER(int, generations, 60, "", Range(1, 100000), "generations of 20 candidates")
  PARAMETER(double, cpuShare, 0.2, "", Range(0.01, 1), "largest share of one core")
  PARAMETER(bool, wait, false, "", Range(),
            "waits for a result that is due, so that a run depends only on its input")
};

MODULE(WalkingEngine)
  REQUIRES(FrameInfo)
  REQUIRES(RobotDescription)
  REQUIRES(MotionRequest)
  REQUIRES(MotionSelection)
  REQUIRES(JointData)
  REQUIRES(SensorData)
  REQUIRES(TorsoAngles)
  PROVIDES(WalkingEngineOutput)
  PARAMETER_GROUP(walking::WalkGaits, walk, "the walk; its values are in walking.yaml")
  PARAMETER_GROUP(WalkFitParameters, fit, "fit of the model to the robot")
  PARAMETER(double, fadeSeconds, motion::walkFade, "s", Range(0, 2),
            "time in which the motion before fades into the walk")
END_MODULE

/// Walks while the walk is selected; once another motion is requested it comes to a stop and stands, which
/// allows the selector to leave it. While another motion moves the robot its output is the stand. While
/// it walks, the model may be fitted to the robot (fit). A parameter of `walk` that is set while it walks
/// counts from the next cycle on; a gait that had the base's value follows the base.
class WalkingEngine : public WalkingEngineBase {
public:
  void parametersChanged() override;
  void init() override;
  void update(WalkingEngineOutput* theWalkingEngineOutput) override;

private:
  void fitModel();

  std::optional<walking::WalkGaits> used_;  ///< the walk as the engine has it; none before init()
  std::optional<walking::WalkEngine> engine_;
  std::unique_ptr<walking::BackgroundFit> fit_;
  std::string robot_;
  bool standing_ = true;  ///< the walk did when it was last selected
};

}  // namespace plumbline
