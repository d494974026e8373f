#pragma once
#include <string>

#include "framework/Representation.h"
#include "robot/HumanoidModel.h"
#include "robot/MechanismFile.h"

namespace plumbline {

/// The robot as data. Only its name travels through streams; what reads one finds the model in the
/// configuration's robots and throws MechanismError if it is not there.
REPRESENTATION(RobotDescription)
class RobotDescription : public RobotDescriptionBase {
public:
  std::string name;  ///< of its file in config/robots; empty: not known yet
  RobotModel model;
  bool known() const { return !name.empty(); }
  void stream(InStream* in, OutStream* out) override {
    const std::string before = name;
    STREAM(name);
    if (in && name != before && known()) model = Humanoid(findMechanism(name)).model();
  }
};

}  // namespace plumbline
