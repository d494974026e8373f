#pragma once
#include "framework/Module.h"
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
END_MODULE

/// Whether the robot stands, falls, lies (and on which side) or sits.
class FallDetector : public FallDetectorBase {
public:
  void init() override;
  void update(FallState* theFallState) override;

private:
  Posture postureNow(const FallState& before);

  double fallingTilt_ = 0, lyingTilt_ = 0, uprightTilt_ = 0;          ///< [rad]
  double lyingSeconds_ = 0, sittingHeight_ = 0, sittingSeconds_ = 0;  ///< [s], [m], [s]
  double tiltedFor_ = 0, lowFor_ = 0;                                 ///< [s]
};

}  // namespace plumbline
