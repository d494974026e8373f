#pragma once
#include <vector>

#include "math/Types.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// A joint with its drive as it is replayed. Everything that no effect touches has its nominal value.
struct JointPlant {
  Servo servo;
  double maxTorque = 0, maxSpeed = 0;  ///< [N m, rad/s]
  double torqueFactor = 1;             ///< on maxTorque; a DC motor has a limit only where this is below 1
  double supplyFactor = 1;             ///< on a DC motor's supply
  bool linkEncoder = false;            ///< position measured behind the gear
  double commandDelay = 0;             ///< [s]
  double accelerationLimit = 0;        ///< of the servo's own profile [rad/s^2]; 0: none
  double deadBand = 0;                 ///< [rad]
  bool deadBandSteps = false;          ///< beyond the band the whole error counts, not what exceeds it
  double extraDamping = 0;             ///< change of kd, which a DC motor adds to its back EMF [N m s/rad]
  double coulomb = 0, viscous = 0;     ///< [N m, N m s/rad]
  double stribeck = 0;                 ///< extra at rest [N m]
  double stribeckSpeed = 0.1;          ///< at which it has fallen to 1/e [rad/s]
  double loadFriction = 0;             ///< share of the torque transmitted
  /// What loads the gear: the motor's torque less what turns its rotor, what reaches the link behind the
  /// friction, or the motor's torque.
  enum class Load { gearTorque, linkTorque, motorTorque };
  Load loadIs = Load::gearTorque;
  double backlash = 0;           ///< whole play [rad]
  double toothStiffness = 4000;  ///< of the flanks of a gear with play, far stiffer than any servo [N m/rad]
  double toothDamping = 0.6;     ///< of them, in parts of twice the critical one of the rotor
  double compliance = 0;         ///< of the gear [rad/(N m)]
  double biasForce = 0;          ///< [N m]
  double deratingPerJoule = 0;   ///< share of maxTorque lost per joule
  bool heatIsWork = false;       ///< joules of |torque * speed|, else of torque squared
  double offset = 0;             ///< link angle minus measured angle [rad]
  double encoderAmplitude = 0, encoderPhase = 0;  ///< measured = true + amplitude sin(true + phase)

  bool geared() const { return backlash > 0 || compliance > 0; }
};

/// A force on a link that no sensor tells of: at its centre of mass, world axes [N].
struct ExternalForce {
  int link = 0;
  Vec3 force = Vec3::Zero();
};

struct ImuPlant {
  Mat3 R_true_sensor = Mat3::Identity();  ///< how the sensor is turned against what the model says
  Vec3 gyroBias = Vec3::Zero();           ///< [rad/s]
  double delay = 0;                       ///< [s]
};

struct GroundPlant {
  double friction = 0.8;
  double compliance = 2e-6;   ///< per contact point [m/N]
  Vec3 slope = Vec3::Zero();  ///< rotation vector of the ground in the world [rad]
  bool putUpright = false;    ///< a robot is put down upright, not level with the ground
};

/// The simulated reality: a mechanism with drives, sensors and ground, all of whose parameters effects set.
struct Plant {
  Mechanism mechanism;
  std::vector<JointPlant> joints;  ///< one per mechanism's joint
  std::vector<double> footGain;    ///< one per foot
  ImuPlant imu;
  GroundPlant ground;
  std::vector<ExternalForce> forces;
  double dropout = 0;  ///< share of lost cycles; which ones is found from the data
};

/// The ground's axes in the world: its normal last.
Mat3 rotationOfGround(const GroundPlant& ground);

/// The plant with nothing unmodelled.
Plant nominalPlant(const Mechanism& mechanism);

}  // namespace plumbline::gap
