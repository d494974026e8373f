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
      used = used || drive.supplySag > 0;
      most += drive.maxTorque;
    }
  }

  bool sags() const { return used; }
  void restart() { load = 0; }
  /// What the motors gave together over a step of h [s]: the sum of the torques' sizes [N m].
  void take(double torques, double h);
  /// Share of the supply that is left for a drive.
  double left(const JointPlant& drive) const;

private:
  bool used = false;
  double most = 0;  ///< [N m]
  double load = 0;  ///< share of it that is drawn
};

}  // namespace plumbline
