#pragma once
#include <string_view>

#include "robot/JointId.h"

namespace plumbline::simspark {

/// A joint under SimSpark's names. angle of this project = sign * angle of SimSpark; the same for speeds:
/// SimSpark turns its pitch joints about the axis that points right, this project about the one that points
/// left.
struct JointName {
  std::string_view perceptor;  ///< "raj1"
  std::string_view effector;   ///< "rae1"
  double sign;                 ///< 1 or -1
};

const JointName& simsparkName(JointId joint);

/// noJoint if there is no such joint.
JointId jointByPerceptor(std::string_view perceptor);
JointId jointByEffector(std::string_view effector);

}  // namespace plumbline::simspark
