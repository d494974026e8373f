#pragma once
#include <memory>
#include <string>

#include "framework/Module.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/JointData.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/modeling/TorsoAngles.h"
#include "representations/motion/JointRequest.h"
#include "representations/motion/ServoRequest.h"
#include "representations/motion/WalkingEngineOutput.h"
#include "walking/engine/ServoLead.h"
#include "walking/parameters/WalkGaits.h"

namespace plumbline {

MODULE(PositionServoControl)
  REQUIRES(FrameInfo)
  REQUIRES(RobotDescription)
  REQUIRES(JointData)
  REQUIRES(TorsoAngles)
  REQUIRES(JointRequest)
  REQUIRES(WalkingEngineOutput)
  PROVIDES(ServoRequest)
END_MODULE

/// Commands with which position servos reach the requested angles in spite of load and lag (ServoLead; the
/// shares are `servo` in walking.yaml, without those of its gaits). Joints that nobody has requested yet stay
/// where they were at the start.
class PositionServoControl : public PositionServoControlBase {
public:
  void init() override;
  void update(ServoRequest* theServoRequest) override;

private:
  void begin();

  walking::WalkGaits gaits_;
  std::string robot_;
  std::unique_ptr<walking::ServoLead> lead_;
  JointTargets targets_;
};

}  // namespace plumbline
