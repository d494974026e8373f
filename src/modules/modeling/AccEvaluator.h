#pragma once
#include <vector>

#include "framework/Module.h"
#include "modules/modeling/ground/SupportOdometry.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/modeling/FKModel.h"
#include "representations/modeling/FallState.h"
#include "representations/modeling/Odometry.h"
#include "representations/modeling/TorsoAngles.h"
#include "representations/motion/WalkingEngineOutput.h"

namespace plumbline {

MODULE(AccEvaluator)
  REQUIRES(FrameInfo)
  REQUIRES(SensorData)
  REQUIRES(RobotDescription)
  REQUIRES(FKModel)
  REQUIRES(TorsoAngles)
  REQUIRES(FallState)
  USES(WalkingEngineOutput)
  PROVIDES(Odometry)
  PARAMETER_CHOICE(source, "feet",
                   "feet: torso over the feet that carry load; walkingEngine: the way as planned", "feet",
                   "walkingEngine")
  PARAMETER(double, airborneSeconds, 0.2, "s", Range(0, 10),
            "time for which the last speed is kept when no foot touches the ground")
END_MODULE

/// How the robot moves over the ground. The turn is the gyroscope's; the way is that of the torso over the
/// feet that carry load (source: feet), or what the walking engine planned (source: walkingEngine).
class AccEvaluator : public AccEvaluatorBase {
public:
  void parametersChanged() override;
  void init() override;
  void update(Odometry* theOdometry) override;

private:
  void findContacts();

  SupportOdometry support_;
  std::vector<SupportOdometry::Contact> contacts_;
  double headingBefore_ = 0;
  bool started_ = false;
};

}  // namespace plumbline
