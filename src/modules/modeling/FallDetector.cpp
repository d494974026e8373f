#include "modules/modeling/FallDetector.h"

#include <algorithm>
#include <cmath>

namespace plumbline {

MAKE_MODULE(FallDetector)

namespace {

/// The side of a lying robot that is down, by the largest component of up.
Posture side(const Vec3& up) {
  if (std::abs(up.x()) >= std::abs(up.y())) return up.x() < 0 ? Posture::onFront : Posture::onBack;
  return up.y() < 0 ? Posture::onLeft : Posture::onRight;
}

bool lies(Posture posture) {
  return posture == Posture::onFront || posture == Posture::onBack || posture == Posture::onLeft ||
         posture == Posture::onRight;
}

}  // namespace

void FallDetector::parametersChanged() {
  if (lyingTilt < fallingTilt) refuse("lyingTilt", "must not be below fallingTilt");
  if (uprightTilt > fallingTilt) refuse("uprightTilt", "must not be above fallingTilt");
}

Posture FallDetector::postureNow(const FallState& before) {
  const Vec3& up = theUprightVec->up;
  const double tilt = std::acos(std::clamp(up.z(), -1.0, 1.0));
  const double dt = theFrameInfo->cycleSeconds;
  tiltedFor_ = tilt > lyingTilt ? tiltedFor_ + dt : 0;
  const bool low = tilt < uprightTilt && theTorsoPose->T_ground_torso.translation().z() < sittingHeight;
  lowFor_ = low ? lowFor_ + dt : 0;

  if (tiltedFor_ > 0 && (lies(before.posture) || tiltedFor_ >= lyingSeconds)) return side(up);
  if (lowFor_ > 0 && (before.posture == Posture::sitting || lowFor_ >= sittingSeconds))
    return Posture::sitting;
  if (tilt < uprightTilt) return Posture::upright;
  // Between the angles what was before goes on: lying until it is up again, upright until it falls.
  if (before.posture != Posture::upright && before.posture != Posture::sitting) return before.posture;
  return tilt > fallingTilt ? Posture::falling : before.posture;
}

void FallDetector::update(FallState* theFallState) {
  if (theFrameInfo->restarted) {
    tiltedFor_ = lowFor_ = 0;
    theFallState->posture = Posture::upright;
    theFallState->since = theFrameInfo->time;
  }
  const Posture before = theFallState->posture, now = postureNow(*theFallState);
  if (now == before) return;
  if (lies(now) && !lies(before)) ++theFallState->falls;
  theFallState->posture = now;
  theFallState->since = theFrameInfo->time;
}

}  // namespace plumbline
