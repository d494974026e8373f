#pragma once
#include "representations/perception/PolarPercepts.h"
#include "simspark/ServerMessage.h"

namespace plumbline {

/// A point of the server's message as modules get it.
inline PolarPoint polarPointOf(const simspark::Polar& polar) {
  PolarPoint point;
  point.distance = polar.distance;
  point.azimuth = polar.azimuth;
  point.elevation = polar.elevation;
  return point;
}

}  // namespace plumbline
