#pragma once
#include "framework/Representation.h"

namespace plumbline {

/// Whether the referee is asked for pass mode: opponents are kept 1 m off the ball for 4 s or until a touch.
REPRESENTATION(PassRequest)
class PassRequest : public PassRequestBase {
public:
  bool active = false;
  void stream(InStream* in, OutStream* out) override { STREAM(active); }
};

}  // namespace plumbline
