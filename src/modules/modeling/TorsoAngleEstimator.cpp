#include "modules/modeling/TorsoAngleEstimator.h"

#include <cmath>

namespace plumbline {

MAKE_MODULE(TorsoAngleEstimator)

void TorsoAngleEstimator::parametersChanged() { filter_.setParameters(filter); }

void TorsoAngleEstimator::execute() {
  if (theFrameInfo->restarted) filter_.reset();
  filter_.update(theSensorData->gyro, theSensorData->acc, theFrameInfo->cycleSeconds);
  if (theFKModel && thePolarLinePercept && !thePolarLinePercept->lines.empty()) lookAtGround();
}

void TorsoAngleEstimator::addToGround(const PolarPoint& point) {
  const double flat = point.distance * std::cos(point.elevation);
  const Vec3 inHead(flat * std::cos(point.azimuth), flat * std::sin(point.azimuth),
                    point.distance * std::sin(point.elevation));
  const double deviation = elevationNoise * point.distance;
  ground_.add(theFKModel->T_torso_head * inHead, deviation * deviation + rangeNoise * rangeNoise);
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
