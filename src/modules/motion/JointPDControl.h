#pragma once
#include <optional>
#include <string>

#include "framework/Module.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/JointData.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/motion/JointRequest.h"
#include "robot/JointVelocityControl.h"

namespace plumbline {

MODULE(JointPDControl)
  REQUIRES(FrameInfo)
  REQUIRES(RobotDescription)
  REQUIRES(JointData)
  REQUIRES(JointRequest)
  PROVIDES(JointRequestWithSpeeds)
  PARAMETER_GROUP(JointVelocityParameters, control, "from joint angles to motor speeds")
  PARAMETER(double, cycle, 0.02, "s", Range(0.001, 0.1), "duration of a cycle of the motors")
END_MODULE

/// Hinge speeds that reach the requested angles as soon as the motors' speed and the platform's delay of one
/// cycle allow. Joints without a request stand still.
class JointPDControl : public JointPDControlBase {
public:
  void parametersChanged() override;
  void update(JointRequestWithSpeeds* theJointRequestWithSpeeds) override;

private:
  std::optional<JointVelocityControl> control_;
  JointArray targets_{};
  std::string robot_;
};

}  // namespace plumbline
