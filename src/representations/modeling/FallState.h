#pragma once
#include <cstdint>

#include "framework/Representation.h"

namespace plumbline {

enum class Posture : std::uint8_t { upright, falling, onFront, onBack, onLeft, onRight, sitting };

REPRESENTATION(FallState)
class FallState : public FallStateBase {
public:
  Posture posture = Posture::upright;
  double since = 0;  ///< time of the last change [s]
  int falls = 0;     ///< from upright or falling to lying, since the start
  bool lying() const { return posture != Posture::upright && posture != Posture::falling; }
  void stream(InStream* in, OutStream* out) override {
    STREAM(posture);
    STREAM(since);
    STREAM(falls);
  }
};

}  // namespace plumbline
