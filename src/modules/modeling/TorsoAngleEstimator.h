#pragma once
#include "framework/Module.h"
#include "modules/modeling/attitude/AttitudeFilter.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/modeling/FKModel.h"
#include "representations/modeling/TorsoAngles.h"
#include "representations/perception/PolarPercepts.h"

namespace plumbline {

MODULE(TorsoAngleEstimator)
REQUIRES(FrameInfo)
REQUIRES(SensorData)
REQUIRES_IF_PROVIDED(FKModel)
REQUIRES_IF_PROVIDED(PolarLinePercept)
PROVIDES(TorsoAngles)
PROVIDES(UprightVec)
END_MODULE

/// Tilt of the torso, and how far it has turned, from gyroscope, accelerometer and the ground that field
/// lines show (see AttitudeFilter).
class TorsoAngleEstimator : public TorsoAngleEstimatorBase {
public:
  void init() override;
  void execute() override;
  void update(TorsoAngles* theTorsoAngles) override;
  void update(UprightVec* theUprightVec) override;

private:
  void lookAtGround();
  void addToGround(const PolarPoint& point);

  AttitudeFilter filter_;
  GroundPlane ground_;
  double elevationNoise_ = 0, rangeNoise_ = 0;  ///< [rad, m]
};

}  // namespace plumbline
