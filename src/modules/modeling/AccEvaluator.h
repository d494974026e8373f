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
#include "representations/motion/MotionOutputs.h"

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
END_MODULE

/// How the robot moves over the ground. The turn is the gyroscope's; the way is that of the torso over the
/// feet that carry load (source: feet), or what the walking engine planned (source: walkingEngine).
class AccEvaluator : public AccEvaluatorBase {
public:
  void init() override;
  void update(Odometry* theOdometry) override;

private:
  void findContacts();

  enum class Source { feet, walkingEngine };
  Source source_ = Source::feet;
  SupportOdometry support_;
  std::vector<SupportOdometry::Contact> contacts_;
  double headingBefore_ = 0;
  bool started_ = false;
};

}  // namespace plumbline
