#pragma once
#include <algorithm>
#include <cmath>

#include "math/Types.h"

namespace plumbline::training {

/// How far a robot comes out of its posture: the angle between the vertical in the torso's frame and its
/// exponential mean (time constant 1 s), which begins upright.
class LeanWatch {
public:
  /// torso: its pose in the world after a cycle of so many seconds.
  void look(const Pose3& torso, double seconds) {
    const Vec3 up = torso.linear().transpose() * Vec3::UnitZ();
    greatest_ = std::max(greatest_, std::acos(std::clamp(up.dot(mean_.normalized()), -1.0, 1.0)));
    mean_ += std::min(1.0, seconds) * (up - mean_);
  }
  double greatest() const { return greatest_; }  ///< so far [rad]

private:
  Vec3 mean_ = Vec3::UnitZ();
  double greatest_ = 0;
};

}  // namespace plumbline::training
