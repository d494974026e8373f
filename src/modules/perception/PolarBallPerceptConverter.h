#pragma once
#include "framework/Module.h"
#include "representations/modeling/FKModel.h"
#include "representations/modeling/TorsoPose.h"
#include "representations/perception/BallPercept.h"
#include "representations/perception/PolarPercepts.h"

namespace plumbline {

MODULE(PolarBallPerceptConverter)
  REQUIRES(PolarBallPercept)
  REQUIRES(TorsoPose)
  REQUIRES(FKModel)
  PROVIDES(BallPercept)
END_MODULE

/// The seen ball relative to the robot on the ground, from the head's pose.
class PolarBallPerceptConverter : public PolarBallPerceptConverterBase {
public:
  void update(BallPercept* theBallPercept) override;
};

}  // namespace plumbline
