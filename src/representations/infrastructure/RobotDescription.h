#pragma once
#include "framework/Representation.h"
#include "robot/RobotModel.h"

namespace plumbline {

/// The robot as data. The model is set once at start; only its type travels through streams.
REPRESENTATION(RobotDescription)
class RobotDescription : public RobotDescriptionBase {
public:
  int type = -1;
  RobotModel model;
  void stream(InStream* in, OutStream* out) override {
    const int before = type;
    STREAM(type);
    if (in && type != before && type >= 0 && type < numSimsparkTypes) model = simsparkRobot(type);
  }
};

}  // namespace plumbline
