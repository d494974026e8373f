#include "training/SprintCut.h"

#include <stdexcept>

namespace plumbline::training {

SprintSpeeds speedsOf(WalkTrialKind direction) {
  switch (direction) {
    case WalkTrialKind::forward:
      return {&walking::SpeedParameters::maxForward, &walking::SpeedParameters::omniForward};
    case WalkTrialKind::backward:
      return {&walking::SpeedParameters::maxBackward, &walking::SpeedParameters::omniBackward};
    case WalkTrialKind::sideways:
      return {&walking::SpeedParameters::maxSideways, &walking::SpeedParameters::omniSideways};
    case WalkTrialKind::turn:
      return {&walking::SpeedParameters::maxTurn, &walking::SpeedParameters::omniTurn};
    case WalkTrialKind::mixture:
    case WalkTrialKind::push:
      break;
  }
  throw std::invalid_argument("a mixture of directions has no sprint");
}

walking::WalkGaits cutSprint(const walking::WalkGaits& gaits, WalkTrialKind direction, double share) {
  const auto [most, omni] = speedsOf(direction);
  walking::WalkGaits cut = gaits;
  walking::WalkParameters& corner = cut.corner[static_cast<std::size_t>(direction)];
  const double mix = gaits.base.speed.*omni;
  // Without a speed of mixtures there is no sprint.
  if (!(mix > 0 && mix < gaits.base.speed.*most)) return cut;
  const double full = mix + share * (gaits.base.speed.*most - mix);
  cut.base.speed.*most = full;
  for (walking::WalkParameters& one : cut.corner) one.speed.*most = full;
  for (const walking::WalkParameter& one : walking::walkParameters()) {
    if (!one.blends) continue;
    const double from = one.of(gaits.base);
    one.of(corner) = from + share * (one.of(corner) - from);
  }
  return cut;
}

walking::WalkGaits cutSprints(const walking::WalkGaits& gaits, double share) {
  walking::WalkGaits cut = gaits;
  for (const WalkTrialKind direction : sprintDirections) cut = cutSprint(cut, direction, share);
  return cut;
}

}  // namespace plumbline::training
