#include "modules/modeling/TorsoAngleEstimator.h"

namespace plumbline {

MAKE_MODULE(TorsoAngleEstimator)

void TorsoAngleEstimator::init() {
  AttitudeFilter::Parameters p;
  p.movingTimeConstant = config.get<double>("movingTimeConstant", {0.1, 1e4});
  p.stillTimeConstant = config.get<double>("stillTimeConstant", {0.01, 1e4});
  p.stillGyro = config.get<double>("stillGyro", {0, 10});
  p.stillAcc = config.get<double>("stillAcc", {0, 10});
  p.stillCycles = config.get<int>("stillCycles", {1, 1000});
  p.averageTimeConstant = config.get<double>("averageTimeConstant", {0.01, 100});
  p.lostAngle = config.get<double>("lostAngle", {0.01, 3.2});
  p.lostSeconds = config.get<double>("lostSeconds", {0, 100});
  filter_ = AttitudeFilter(p);
}

void TorsoAngleEstimator::execute() {
  if (theFrameInfo->restarted) filter_.reset();
  filter_.update(theSensorData->gyro, theSensorData->acc, theFrameInfo->cycleSeconds);
}

void TorsoAngleEstimator::update(TorsoAngles* theTorsoAngles) {
  theTorsoAngles->roll = filter_.roll();
  theTorsoAngles->pitch = filter_.pitch();
  theTorsoAngles->heading = filter_.heading();
}

void TorsoAngleEstimator::update(UprightVec* theUprightVec) { theUprightVec->up = filter_.up(); }

}  // namespace plumbline
