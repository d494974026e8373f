#pragma once
#include <vector>

#include "framework/Representation.h"
#include "math/Types.h"

namespace plumbline {

/// Where the links are for the measured joint angles; torso frame.
REPRESENTATION(FKModel)
class FKModel : public FKModelBase {
public:
  std::vector<Pose3> T_torso_link;             ///< one per RobotModel::links
  Vec3 com = Vec3::Zero();                     ///< centre of mass of the robot [m]
  Pose3 T_torso_leftSole = Pose3::Identity();  ///< centre of the sole's underside
  Pose3 T_torso_rightSole = Pose3::Identity();
  Pose3 T_torso_head = Pose3::Identity();  ///< centre of the head, where SimSpark's camera is
  void stream(InStream* in, OutStream* out) override {
    STREAM(T_torso_link);
    STREAM(com);
    STREAM(T_torso_leftSole);
    STREAM(T_torso_rightSole);
    STREAM(T_torso_head);
  }
};

}  // namespace plumbline
