#pragma once
#include <string>

#include "framework/Module.h"
#include "modules/evaluation/ErrorStatistics.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GroundTruth.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/FallState.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/TorsoAngles.h"

namespace plumbline {

MODULE(LocalizationEvaluation)
  REQUIRES(FrameInfo)
  REQUIRES(GroundTruth)
  REQUIRES(RobotPose)
  REQUIRES(BallPos)
  REQUIRES(UprightVec)
  REQUIRES(FallState)
  PARAMETER(std::string, file, "build/run/localization.json", "", Range(),
            "medians and 95th percentiles, written when the agent ends")
END_MODULE

/// Compares the estimated pose, ball and tilt with the ground truth in every cycle and writes medians and
/// 95th percentiles to a JSON file when the agent ends. Only where modules.cfg asks for it.
class LocalizationEvaluation : public LocalizationEvaluationBase {
public:
  ~LocalizationEvaluation() override;
  void init() override;
  void execute() override;

private:
  std::string report() const;

  bool begun_ = false;                    ///< there is a file to be written
  double firstTime_ = -1, lastTime_ = 0;  ///< [s]
  std::size_t cycles_ = 0, validCycles_ = 0;
  ErrorStatistics position_, heading_, ball_, ballRelative_, tilt_;  ///< m, degrees, m, m, degrees
};

}  // namespace plumbline
