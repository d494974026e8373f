#pragma once
#include "framework/Module.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/motion/MotionOutputs.h"
#include "walking/WalkGaits.h"

namespace plumbline {

MODULE(StandMotion)
REQUIRES(RobotDescription)
PROVIDES(StandOutput)
END_MODULE

/// Stands as the walk does between steps, so that walk and stand need no way from one to the other.
class StandMotion : public StandMotionBase {
public:
  void init() override;
  void update(StandOutput* theStandOutput) override;

private:
  walking::WalkGaits gaits_;
  int type_ = -1;
};

}  // namespace plumbline
