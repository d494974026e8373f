#pragma once
#include <optional>

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
END_MODULE

/// Hinge speeds that reach the requested angles as soon as the motors' speed and the platform's delay of one
/// cycle allow. Joints without a request stand still.
class JointPDControl : public JointPDControlBase {
public:
  void init() override;
  void update(JointRequestWithSpeeds* theJointRequestWithSpeeds) override;

private:
  JointVelocityParameters parameters_;
  double cycle_ = 0;  ///< [s]
  std::optional<JointVelocityControl> control_;
  JointArray targets_{};
  int type_ = -1;
};

}  // namespace plumbline
