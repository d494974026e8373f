#pragma once
#include <vector>

#include "math/Types.h"
#include "robot/JointPlant.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// A force on a link that no sensor measures: at its centre of mass, world axes [N].
struct ExternalForce {
  int link = 0;
  Vec3 force = Vec3::Zero();
};

struct ImuPlant {
  Mat3 R_true_sensor = Mat3::Identity();  ///< rotation of the sensor relative to the model
  Vec3 gyroBias = Vec3::Zero();           ///< [rad/s]
  double delay = 0;                       ///< [s]
};

struct GroundPlant {
  double friction = 0.8;
  double compliance = 2e-6;   ///< per contact point [m/N]
  Vec3 slope = Vec3::Zero();  ///< rotation vector of the ground in the world [rad]
  bool putUpright = false;    ///< a robot is put down upright, not perpendicular to the ground
};

/// The simulated reality: a mechanism with drives, sensors and ground. Effects change its parameters.
struct Plant {
  Mechanism mechanism;
  std::vector<JointPlant> joints;  ///< one per mechanism's joint
  std::vector<double> footGain;    ///< one per foot
  ImuPlant imu;
  GroundPlant ground;
  std::vector<ExternalForce> forces;
  double dropout = 0;  ///< share of lost cycles; the data shows which ones
};

/// The ground's axes in the world; the last one is its normal.
Mat3 rotationOfGround(const GroundPlant& ground);

/// The plant without any effect.
Plant nominalPlant(const Mechanism& mechanism);

}  // namespace plumbline::gap
