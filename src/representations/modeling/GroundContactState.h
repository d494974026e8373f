#pragma once
#include "framework/Representation.h"

namespace plumbline {

REPRESENTATION(GroundContactState)
class GroundContactState : public GroundContactStateBase {
public:
  bool contact = false;  ///< at least one foot carries the robot
  bool leftContact = false;
  bool rightContact = false;
  double leftLoad = 0;  ///< filtered vertical force [N]
  double rightLoad = 0;
  void stream(InStream* in, OutStream* out) override {
    STREAM(contact);
    STREAM(leftContact);
    STREAM(rightContact);
    STREAM(leftLoad);
    STREAM(rightLoad);
  }
};

}  // namespace plumbline
