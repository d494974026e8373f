#pragma once
#include "framework/Module.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/JointData.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/motion/MotionRequest.h"
#include "representations/motion/ServoRequest.h"

namespace plumbline {

MODULE(ServoSensors)
  PROVIDES(FrameInfo)
  PROVIDES(PlayerInfo)
  PROVIDES(JointData)
  PROVIDES(SensorData)
END_MODULE

/// What the robot of test::ServoWorld feels; it sees nothing.
class ServoSensors : public ServoSensorsBase {
public:
  void update(FrameInfo* theFrameInfo) override;
  void update(PlayerInfo* thePlayerInfo) override;
  void update(JointData* theJointData) override;
  void update(SensorData* theSensorData) override;
};

MODULE(ServoWish)
  PROVIDES(MotionRequest)
END_MODULE

/// What the test asks for.
class ServoWish : public ServoWishBase {
public:
  void update(MotionRequest* theMotionRequest) override;
};

MODULE(ServoMotors)
  REQUIRES(ServoRequest)
END_MODULE

/// Ends the cycle.
class ServoMotors : public ServoMotorsBase {
public:
  void execute() override;
};

}  // namespace plumbline
