#pragma once
#include "framework/Module.h"
#include "motion/MotionDefaults.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/FallState.h"
#include "representations/modeling/TorsoAngles.h"
#include "representations/modeling/TorsoPose.h"

namespace plumbline {

MODULE(FallDetector)
  REQUIRES(FrameInfo)
  REQUIRES(UprightVec)
  REQUIRES(TorsoPose)
  PROVIDES(FallState)
  PARAMETER(double, fallingTilt, 0.6, "rad", Range(0, 3.2), "an upright robot that is tilted more falls")
  PARAMETER(double, lyingTilt, motion::lyingTilt, "rad", Range(0, 3.2),
            "a robot that is tilted more for lyingSeconds lies")
  PARAMETER(double, lyingSeconds, motion::lyingSeconds, "s", Range(0, 10), "see lyingTilt")
  PARAMETER(double, uprightTilt, motion::uprightTilt, "rad", Range(0, 3.2),
            "a robot that is tilted less is up again")
  PARAMETER(double, sittingHeight, 0.22, "m", Range(0, 1),
            "an upright torso that is lower for sittingSeconds sits")
  PARAMETER(double, sittingSeconds, 1, "s", Range(0, 100), "see sittingHeight")
END_MODULE

/// Whether the robot stands, falls, lies (and on which side) or sits.
class FallDetector : public FallDetectorBase {
public:
  void parametersChanged() override;
  void update(FallState* theFallState) override;

private:
  Posture postureNow(const FallState& before);

  double tiltedFor_ = 0, lowFor_ = 0;  ///< [s]
};

}  // namespace plumbline
