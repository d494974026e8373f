#pragma once
#include "framework/Module.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/modeling/GroundContactState.h"

namespace plumbline {

MODULE(GroundContactDetector)
  REQUIRES(FrameInfo)
  REQUIRES(SensorData)
  PROVIDES(GroundContactState)
  PARAMETER(double, timeConstant, 0.03, "s", Range(0, 10), "time constant of the low-pass on the load")
  PARAMETER(double, contactLoad, 6, "N", Range(0, 1000), "a foot with more load touches the ground")
  PARAMETER(double, releaseLoad, 2, "N", Range(0, 1000), "a foot with less load has left the ground")
END_MODULE

/// Which feet carry the robot, from the force sensors, low-pass filtered.
class GroundContactDetector : public GroundContactDetectorBase {
public:
  void parametersChanged() override;
  void update(GroundContactState* theGroundContactState) override;
};

}  // namespace plumbline
