#pragma once
#include <string>

#include "framework/Module.h"
#include "motion/MotionDefaults.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/motion/StandOutput.h"
#include "walking/parameters/WalkGaits.h"

namespace plumbline {

MODULE(StandMotion)
  REQUIRES(RobotDescription)
  PROVIDES(StandOutput)
  PARAMETER(double, fadeSeconds, motion::standFade, "s", Range(0, 2),
            "time in which the motion before fades into the stand")
END_MODULE

/// Stands as the walk does between steps, so that walk and stand need no way from one to the other.
class StandMotion : public StandMotionBase {
public:
  void init() override;
  void update(StandOutput* theStandOutput) override;

private:
  walking::WalkGaits gaits_;
  std::string robot_;
};

}  // namespace plumbline
