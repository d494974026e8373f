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
  PARAMETER_GROUP(AttitudeFilter::Parameters, filter, "the filter of the tilt")
  PARAMETER(double, elevationNoise, 0.00214, "rad", Range(1e-6, 1),
            "standard deviation of the elevation of seen points")
  PARAMETER(double, rangeNoise, 0.004, "m", Range(1e-6, 1), "standard deviation of seen points nearby")
END_MODULE

/// Tilt of the torso, and how far it has turned, from gyroscope, accelerometer and the ground that field
/// lines show (see AttitudeFilter).
class TorsoAngleEstimator : public TorsoAngleEstimatorBase {
public:
  void parametersChanged() override;
  void execute() override;
  void update(TorsoAngles* theTorsoAngles) override;
  void update(UprightVec* theUprightVec) override;

private:
  void lookAtGround();
  void addToGround(const PolarPoint& point);

  AttitudeFilter filter_;
  GroundPlane ground_;
};

}  // namespace plumbline
