#pragma once
#include <optional>

#include "math/Types.h"
#include "parameters/Parameter.h"
#include "representations/perception/PolarPercepts.h"

namespace plumbline {

/// A robot's pose by its visible parts, on the ground relative to the robot that sees.
struct BodyView {
  Vec2 position = Vec2::Zero();        ///< of its middle [m]
  Mat2 covariance = Mat2::Identity();  ///< [m^2]
  bool postureKnown = false, fallen = false;
};

struct BodyViewParameters {
  PARAMETERS(BodyViewParameters)
  PARAMETER(double, bodyNoise, 0.05, "m", Range(1e-3, 1), "how far a visible part is from the robot's middle")
  PARAMETER(double, distanceShare, 0.002, "", Range(0, 1),
            "standard deviation along the line of sight, share of the distance")
  PARAMETER(double, angleNoise, 0.004, "rad", Range(0, 1), "standard deviation across the line of sight")
  PARAMETER(double, fallenHeight, 0.3, "m", Range(0.05, 1), "a head that is lower belongs to a fallen robot")
};

/// The middle is under the head of a robot that stands; of one that lies, or shows no head, it is the mean of
/// its parts. Nothing if no part is plausible (nearer than 0.15 m, farther than 60 m, under the ground or
/// higher than a robot).
std::optional<BodyView> viewBody(const PolarPlayer& player, const Pose3& T_ground_head,
                                 const BodyViewParameters& parameters);

}  // namespace plumbline
