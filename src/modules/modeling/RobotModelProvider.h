#pragma once
#include <memory>
#include <string>

#include "framework/Module.h"
#include "representations/infrastructure/JointData.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/modeling/FKModel.h"
#include "robot/ForwardKinematics.h"

namespace plumbline {

MODULE(RobotModelProvider)
  REQUIRES(PlayerInfo)
  REQUIRES(JointData)
  PROVIDES(RobotDescription)
  PROVIDES(FKModel)
END_MODULE

/// The robot that PlayerInfo names, and where its links are for the measured angles.
class RobotModelProvider : public RobotModelProviderBase {
public:
  void execute() override;
  void update(RobotDescription* theRobotDescription) override;
  void update(FKModel* theFKModel) override;

private:
  std::string name_;
  RobotModel model_;
  std::unique_ptr<ForwardKinematics> kinematics_;
  int head_ = 0, leftFoot_ = 0, rightFoot_ = 0;
  Pose3 T_leftFoot_sole_ = Pose3::Identity(), T_rightFoot_sole_ = Pose3::Identity();
};

}  // namespace plumbline
