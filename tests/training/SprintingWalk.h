#pragma once
#include "walking/parameters/WalkGaits.h"

namespace plumbline::training {

/// A slow walk whose sprint forward is three times as quick and higher.
inline walking::WalkGaits sprintingWalk() {
  walking::WalkParameters base;
  base.speed.omniForward = 0.2;
  base.speed.maxForward = 0.6;
  base.speed.omniSideways = 0.1;
  base.speed.maxSideways = 0.3;
  base.step.height = 0.02;
  walking::WalkGaits gaits(base);
  gaits.corner[0].step.height = 0.04;
  return gaits;
}

}  // namespace plumbline::training
