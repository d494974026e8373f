#pragma once
#include <cmath>

#include "simulation/world/World.h"
#include "walking/estimation/WalkSensors.h"

namespace plumbline::training {

/// The foot sensors that the walk gets, toes included, rounded as the league's server prints them: 0.01 N, 1
/// cm.
inline walking::FootSensors feltFeet(const simulation::RobotReadings& readings) {
  return walking::feltFeet(
      readings, [](const std::optional<simulation::FootForce>& force) -> std::optional<walking::FootContact> {
        if (!force) return std::nullopt;
        const auto printed = [](const Vec3& v) {
          return Vec3(v.unaryExpr([](double x) { return std::round(x / 0.01) * 0.01; }));
        };
        return walking::FootContact{printed(force->point), printed(force->force)};
      });
}

}  // namespace plumbline::training
