#pragma once
#include <string>

#include "math/Angle.h"
#include "robot/MjcfDefaults.h"

namespace plumbline {

/// Mass, centre of mass and inertia about it.
struct MjcfLump {
  double mass = 0;
  Vec3 com = Vec3::Zero();
  Mat3 inertia = Mat3::Zero();

  void add(const MjcfLump& other) {
    if (other.mass <= 0) return;
    const double whole = mass + other.mass;
    const Vec3 apart = other.com - com;
    inertia += other.inertia + mass * other.mass / whole *
                                   (apart.squaredNorm() * Mat3::Identity() - apart * apart.transpose());
    com += other.mass / whole * apart;
    mass = whole;
  }
};

/// Places, turns and masses in a model of MuJoCo.
class MjcfSolids : public MjcfDefaults {
public:
  using MjcfDefaults::MjcfDefaults;

protected:
  /// Of what has a quat, euler, axisangle, xyaxes or zaxis.
  Mat3 rotationOf(const XMLElement& e) const;
  /// What an <inertial> says.
  MjcfLump inertialOf(const XMLElement& e) const;
  /// Of a solid geom: its own mass, or its volume times its density.
  MjcfLump lumpOf(const XMLElement& e) const;

  double unit = fromDegrees(1);  ///< of angles
  std::string eulerSequence = "xyz";
};

}  // namespace plumbline
