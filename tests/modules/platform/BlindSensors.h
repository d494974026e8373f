#pragma once
#include "framework/Module.h"
#include "representations/infrastructure/GameState.h"
#include "representations/perception/HearPercept.h"
#include "representations/perception/PolarPercepts.h"

namespace plumbline {

MODULE(BlindSensors)
  PROVIDES(GameState)
  PROVIDES(VisionInfo)
  PROVIDES(PolarBallPercept)
  PROVIDES(PolarLandmarkPercept)
  PROVIDES(PolarLinePercept)
  PROVIDES(PolarPlayerPercept)
  PROVIDES(HearPercept)
END_MODULE

/// What a robot that sees and hears nothing, and plays no game, says of that: initial values.
class BlindSensors : public BlindSensorsBase {
public:
  void update(GameState*) override {}
  void update(VisionInfo*) override {}
  void update(PolarBallPercept*) override {}
  void update(PolarLandmarkPercept*) override {}
  void update(PolarLinePercept*) override {}
  void update(PolarPlayerPercept*) override {}
  void update(HearPercept*) override {}
};

}  // namespace plumbline
