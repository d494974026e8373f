#pragma once
#include "framework/Module.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/JointData.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/motion/JointRequest.h"
#include "representations/motion/MotionRequest.h"

namespace plumbline {

MODULE(ScriptedSensors)
  PROVIDES(FrameInfo)
  PROVIDES(PlayerInfo)
  PROVIDES(JointData)
  PROVIDES(SensorData)
END_MODULE

/// What the robot of test::ScriptedWorld feels; it sees nothing.
class ScriptedSensors : public ScriptedSensorsBase {
public:
  void update(FrameInfo* theFrameInfo) override;
  void update(PlayerInfo* thePlayerInfo) override { thePlayerInfo->robot = "simspark_type0"; }
  void update(JointData* theJointData) override;
  void update(SensorData* theSensorData) override;
};

MODULE(ScriptedWish)
  REQUIRES(FrameInfo)
  PROVIDES(MotionRequest)
END_MODULE

/// Stands, and then walks in place.
class ScriptedWish : public ScriptedWishBase {
public:
  void update(MotionRequest* theMotionRequest) override;
};

MODULE(ScriptedMotors)
  REQUIRES(JointRequestWithSpeeds)
END_MODULE

/// Ends the cycle.
class ScriptedMotors : public ScriptedMotorsBase {
public:
  void execute() override;
};

}  // namespace plumbline
