#pragma once
#include "framework/Module.h"
#include "modules/modeling/attitude/AttitudeFilter.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/modeling/TorsoAngles.h"

namespace plumbline {

MODULE(TorsoAngleEstimator)
REQUIRES(FrameInfo)
REQUIRES(SensorData)
PROVIDES(TorsoAngles)
PROVIDES(UprightVec)
END_MODULE

/// Tilt of the torso, and how far it has turned, from gyroscope and accelerometer (see AttitudeFilter).
class TorsoAngleEstimator : public TorsoAngleEstimatorBase {
public:
  void init() override;
  void execute() override;
  void update(TorsoAngles* theTorsoAngles) override;
  void update(UprightVec* theUprightVec) override;

private:
  AttitudeFilter filter_;
};

}  // namespace plumbline
