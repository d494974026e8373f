#pragma once
#include <vector>

#include "robot/JointPlant.h"

namespace plumbline {

/// A supply that sags under load: its voltage falls with the sum of the motors' torques, for which currents
/// are taken (an inner resistance), and follows them over 10 ms (the capacitors of the line).
class SupplyRail {
public:
  explicit SupplyRail(const std::vector<JointPlant>& drives) {
    for (const JointPlant& drive : drives) {
      used_ = used_ || drive.supplySag > 0;
      most_ += drive.maxTorque;
    }
  }

  bool hasVoltageDrop() const { return used_; }
  void restart() { load_ = 0; }
  /// Load of all motors over a step of h [s]: the sum of the absolute torques [N m].
  void take(double torques, double h);
  /// Share of the supply that is left for a drive.
  double left(const JointPlant& drive) const;

private:
  bool used_ = false;
  double most_ = 0;  ///< [N m]
  double load_ = 0;  ///< share of it that is drawn
};

}  // namespace plumbline
