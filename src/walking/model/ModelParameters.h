#pragma once
#include <array>
#include <cstddef>

namespace plumbline::walking {

/// The ten numbers that fit the pendulum to a robot (section 4.3.1, table 4.2 of the thesis): they act
/// between the walk state and the pendulum, which stays as it is. The defaults change nothing.
struct ModelParameters {
  static constexpr std::size_t count = 10;

  double massOffsetX = 0, massOffsetY = 0;    ///< centre of mass before, left of where it is taken to be [m]
  double massOffsetZx = 0, massOffsetZy = 0;  ///< and above it, for the motion along x, y [m]
  double velocityOffsetX = 0, velocityOffsetY = 0;  ///< added to the estimated velocity [m/s]
  double footFactorX = 1, footFactorY = 1;          ///< of the foot's position along x, y
  double footFactor = 1;                            ///< of both
  double timeFactor = 1;                            ///< of the time that passes in the pendulum

  std::array<double, count> values() const {
    return {massOffsetX,     massOffsetY, massOffsetZx, massOffsetZy, velocityOffsetX,
            velocityOffsetY, footFactorX, footFactorY,  footFactor,   timeFactor};
  }
  static ModelParameters of(const std::array<double, count>& v) {
    return {v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9]};
  }
};

/// Name, neutral value and how far from it a fit looks, in the order of ModelParameters::values().
struct ModelParameterInfo {
  const char* name;
  double neutral, scale;  ///< scale: a typical deviation
  double low, high;
};
inline constexpr std::array<ModelParameterInfo, ModelParameters::count> modelParameterTable{{
    {"mass offset x", 0, 0.005, -0.04, 0.04},
    {"mass offset y", 0, 0.005, -0.04, 0.04},
    {"mass offset z (for x movement)", 0, 0.02, -0.1, 0.2},
    {"mass offset z (for y movement)", 0, 0.02, -0.1, 0.2},
    {"velocity offset x", 0, 0.02, -0.2, 0.2},
    {"velocity offset y", 0, 0.02, -0.2, 0.2},
    {"foot position factor x", 1, 0.05, 0.6, 1.6},
    {"foot position factor y", 1, 0.05, 0.6, 1.6},
    {"foot position factor", 1, 0.05, 0.6, 1.6},
    {"time factor", 1, 0.05, 0.6, 1.6},
}};

}  // namespace plumbline::walking
