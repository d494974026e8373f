#include "modules/modeling/TorsoAngleEstimator.h"

#include <cmath>

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
  p.tiltNoise = config.get<double>("tiltNoise", {0, 1});
  p.groundGate = config.get<double>("groundGate", {0.1, 1000});
  elevationNoise_ = config.get<double>("elevationNoise", {1e-6, 1});
  rangeNoise_ = config.get<double>("rangeNoise", {1e-6, 1});
  filter_ = AttitudeFilter(p);
}

void TorsoAngleEstimator::execute() {
  if (theFrameInfo->restarted) filter_.reset();
  filter_.update(theSensorData->gyro, theSensorData->acc, theFrameInfo->cycleSeconds);
  if (theFKModel && thePolarLinePercept && !thePolarLinePercept->lines.empty()) lookAtGround();
}

void TorsoAngleEstimator::addToGround(const PolarPoint& point) {
  const double flat = point.distance * std::cos(point.elevation);
  const Vec3 inHead(flat * std::cos(point.azimuth), flat * std::sin(point.azimuth),
                    point.distance * std::sin(point.elevation));
  const double deviation = elevationNoise_ * point.distance;
  ground_.add(theFKModel->T_torso_head * inHead, deviation * deviation + rangeNoise_ * rangeNoise_);
}

void TorsoAngleEstimator::lookAtGround() {
  ground_.clear();
  for (const PolarLine& line : thePolarLinePercept->lines) {
    addToGround(line.a);
    addToGround(line.b);
  }
  GroundPlane::Fit fit;
  if (ground_.fit(theFKModel->T_torso_head.translation(), fit)) filter_.seeGround(fit);
}

void TorsoAngleEstimator::update(TorsoAngles* theTorsoAngles) {
  theTorsoAngles->roll = filter_.roll();
  theTorsoAngles->pitch = filter_.pitch();
  theTorsoAngles->heading = filter_.heading();
}

void TorsoAngleEstimator::update(UprightVec* theUprightVec) { theUprightVec->up = filter_.up(); }

}  // namespace plumbline
