#pragma once
#include "simulation/physics/Physics.h"

namespace plumbline::simulation {

/// Above this spin, a light link's drag uses the velocity at the end of the step [rad/s]. No motor of the
/// league turns faster than 7, and in recordings of its server no link reaches 19.
constexpr double fastSpin = 20;

/// Torque of a body's angular drag over a step of h seconds [N m], world axes, by its rotation and its spin
/// w.
///
/// The league's server uses the spin at the beginning of the step. If no motor, stop or contact holds a light
/// link, as beyond its stop, that reverses and increases its spin: a toe's by twenty times a step. For a fast
/// link the spin at the end of the step is used, which brakes with any step: (I + h d) w' = I w, torque = -d
/// w'.
inline Vec3 dragTorque(const BodySpec& body, const Mat3& rotation, const Vec3& w, double h) {
  const double d = body.angularDrag;
  if (w.squaredNorm() <= fastSpin * fastSpin || h * d * body.inertia.inverse().trace() <= 1) return -d * w;
  const Mat3 braked = body.inertia + h * d * Mat3::Identity();
  return -d * (rotation * (braked.inverse() * (body.inertia * (rotation.transpose() * w))));
}

}  // namespace plumbline::simulation
