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
END_MODULE

/// Which feet carry the robot, from the force sensors, low-pass filtered.
class GroundContactDetector : public GroundContactDetectorBase {
public:
  void init() override;
  void update(GroundContactState* theGroundContactState) override;

private:
  double timeConstant_ = 0;  ///< of the low-pass [s]
  double on_ = 0, off_ = 0;  ///< load that makes a contact, and below which it ends [N]
};

}  // namespace plumbline
