#include "modules/modeling/RobotModelProvider.h"

#include "robot/LegKinematics.h"

namespace plumbline {

MAKE_MODULE(RobotModelProvider)

void RobotModelProvider::execute() {
  if (thePlayerInfo->robot != name_) {
    name_ = thePlayerInfo->robot;
    model_ = Humanoid(findMechanism(name_)).model();
    kinematics_ = std::make_unique<ForwardKinematics>(model_);
    head_ = model_.linkOfJoint[model_.requireJoint("HeadPitch")];
    leftFoot_ = model_.linkOfJoint[model_.requireJoint("LAnkleRoll")];
    rightFoot_ = model_.linkOfJoint[model_.requireJoint("RAnkleRoll")];
    T_leftFoot_sole_ = LegKinematics(model_, Side::left).T_foot_sole();
    T_rightFoot_sole_ = LegKinematics(model_, Side::right).T_foot_sole();
  }
  if (kinematics_) kinematics_->update(theJointData->angles);
}

void RobotModelProvider::update(RobotDescription* theRobotDescription) {
  if (theRobotDescription->name == name_) return;
  theRobotDescription->name = name_;
  theRobotDescription->model = model_;
}

void RobotModelProvider::update(FKModel* theFKModel) {
  if (!kinematics_) return;
  theFKModel->T_torso_link.resize(model_.links.size());
  for (std::size_t i = 0; i < model_.links.size(); ++i)
    theFKModel->T_torso_link[i] = kinematics_->link(static_cast<int>(i));
  theFKModel->com = kinematics_->com();
  theFKModel->T_torso_leftSole = kinematics_->link(leftFoot_) * T_leftFoot_sole_;
  theFKModel->T_torso_rightSole = kinematics_->link(rightFoot_) * T_rightFoot_sole_;
  const Link& head = model_.links[static_cast<std::size_t>(head_)];
  theFKModel->T_torso_head = kinematics_->link(head_) * translation(head.com);
}

}  // namespace plumbline
