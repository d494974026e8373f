#pragma once
#include <span>

namespace plumbline::walking {

/// Everything about the walk that a user may set. The defaults make every robot of the league walk slowly;
/// config/robots/*/walking.yaml holds the values found for each. Ranges: walkParameterTable().
struct WalkParameters {
  // Posture
  double hipHeight = 0.20;       ///< hip joints over the sole [m]
  double feetDistance = 0.11;    ///< between the soles' centres, walking on the spot [m]
  double torsoPitch = 0;         ///< lean forward [rad]
  double torsoPitchForward = 0;  ///< more of it per forward speed [rad s/m]

  // Speed
  double trimForward = 0;     ///< planned speed with which the robot stays on the spot [m/s]
  double brakeLead = 0;       ///< for which the planned speed is ahead while the robot brakes [s]
  double speedAverage = 0;    ///< walking time over which it is learnt how much faster than planned the robot
                              ///< walks (SpeedScale), 0: it is not [s]
  double maxForward = 0.5;    ///< [m/s]
  double maxBackward = 0.4;   ///< [m/s]
  double maxSideways = 0.25;  ///< [m/s]
  double maxTurn = 1.6;       ///< [rad/s]
  double mixForward = 0;      ///< up to here any mixture of directions may be asked for; 0: up to the
  double mixBackward = 0;     ///< full speed. More is walked in one direction alone [m/s]
  double mixSideways = 0, mixTurn = 0;  ///< the same [m/s, rad/s]
  double sprintPatience = 0.3;          ///< for which more has to be asked for [s]
  double sprintAside = 0.23;            ///< share of the mixable speeds that is walked beside a sprint
  double sprintRise = 0;                ///< from the speed of mixtures to full speed [s]
  double sprintFall = 0;                ///< and back, both 0: with the accelerations below [s]
  double sprintSettle = 0;              ///< straight on for so long when a sprint is over [s]
  double accelerationForward = 0.5;     ///< of the requested velocity [m/s^2]
  double decelerationForward = 0.5;     ///< the same when it becomes smaller [m/s^2]
  double accelerationSideways = 0.5;    ///< [m/s^2]
  double accelerationTurn = 6;          ///< [rad/s^2]

  // Step
  double stepDuration = 0.18;     ///< of one step in the reference [s]
  double minStepDuration = 0.12;  ///< [s]
  double maxStepDuration = 0.30;  ///< [s]
  double maxStepForward = 0.10;   ///< swing target before the centre of mass [m]
  double maxStepBackward = 0.08;  ///< the same behind it [m]
  double maxStepOutward = 0.14;   ///< the same beside it [m]
  double minFeetDistance = 0.09;  ///< the feet do not cross: least distance of the soles' centres [m]
  double stepHeight = 0.02;       ///< of the swing foot [m]
  double swingStart = 0;          ///< share of the step before the swing foot moves over the ground
  double swingEnd = 1;            ///< share of the step when it has arrived
  double swingSmoothness = 0.5;   ///< 0: constant speed over the ground, 1: from rest to rest
  double swingSteepness = 1.5;    ///< of lifting and lowering: 1 a sine arch, 2 from rest to rest
  double swingPitch = 0;          ///< of the swing foot when highest, toes down [rad]

  // Model
  double pendulumHeight = 0.25;  ///< of the centre of mass over the ground in the pendulum [m]
  double pendulumSideways = 0;   ///< added to it for the motion sideways [m]
  double copForward = 0;         ///< pressure on the supporting sole, before its centre [m]
  double copOutward = 0;         ///< the same to the outside [m]

  // Start and stop
  double startDuration = 0.14;  ///< shift of the weight before the first step [s]
  double startSpeed = 0;        ///< forward or backward in that step, if asked for [m/s]
  double stopVelocity = 0.05;   ///< both feet carry again only below this forward velocity [m/s]

  // Kick in a step
  double kickDuration = 0.24;  ///< of the step that kicks [s]
  double kickBack = 0.04;      ///< the foot is drawn back [m]
  double kickForward = 0.09;   ///< and thrown forward [m]

  // Feedback from the torso's angle and turn rate; zero is the open loop
  double delay = 0.04;       ///< between a measurement and the effect of what it causes [s]
  double tiltAverage = 0;    ///< time over which a lasting tilt is taken as usual, 0: none is [s]
  double ankleRollGain = 0;  ///< torso angle to the supporting ankle
  double anklePitchGain = 0;
  double ankleRollRate = 0;  ///< torso turn rate to the supporting ankle [s]
  double anklePitchRate = 0;
  double stepForwardGain = 0;  ///< share of the tilt that step planning takes for the pendulum moving
  double stepSidewaysGain = 0;
  double swingLevel = 0;   ///< share of the tilt that the swing foot is turned back by
  double hipRollGain = 0;  ///< torso angle to the supporting hip (section 4.2.7)
  double hipPitchGain = 0;
  double hipRollRate = 0;  ///< torso turn rate to the supporting hip [s]
  double hipPitchRate = 0;
  double comForwardGain = 0;  ///< share of the tilt that the mass is moved back over the feet by
  double comSidewaysGain = 0;
  double tiltTolerance = 0.2;  ///< torso's deviation from its plan beyond which the walk slows down [rad]
  double tiltBrake = 0;        ///< share of the requested speed taken off per such deviation [1/rad]

  // Observation (section 4.2.5); both shares 0: the walk state follows the model alone
  double observationDelay = 0.04;  ///< between a command and the measurement that shows it [s]
  double observationPosition = 0;  ///< share of the observed error of the feet taken over in a cycle
  double observationVelocity = 0;  ///< the same of the velocity
  double observationSideways = 1;  ///< times this in the velocity sideways
  double observationBeside = 1;    ///< and this in the place of the feet sideways
  double imuAverage = 0;           ///< time over which IMU and legs are compared, 0: the IMU is right [s]

  // Recovery from a push: how far the capture point is off its usual place
  double usualAverage = 0;        ///< time over which an error of the model is taken as usual, 0: none is [s]
  double recoverFrom = 0.03;      ///< from here on the walk recovers (WalkGaits::recovery) [m]
  double recoverFull = 0;         ///< and does nothing else; not above recoverFrom: never [m]
  double recoverTime = 0.5;       ///< until it walks as before [s]
  double captureMargin = 1;       ///< standing: steps when the capture point is so far outside the soles [m]
  double swingMeasuredPitch = 0;  ///< share of the measured tilt that the swing foot is placed for
  double swingMeasuredRoll = 0;   ///< the same

  // Force sensors: when a step ends
  double contactShare = 0;  ///< of the weight on the swing foot that makes it carry, 0: steps end as planned
  double contactPhase = 0.7;  ///< but not before this share of the step
  double contactWait = 0;     ///< a step lasts so much longer at most where the ground is not there yet [s]

  // Servos, where the platform has them
  double hipHardness = 1;    ///< stiffness of the joints, 0 .. 1
  double kneeHardness = 1;   ///< the same
  double ankleHardness = 1;  ///< the same
  double loadLead = 0;  ///< share of what a servo gives way under the robot's weight that targets lead by
  double rateLead = 0;  ///< the same of its lag behind a moving target

  // Fall: torso's angle plus fallLead times its rate, beyond which it cannot be stopped any more
  double fallRoll = 0;     ///< [rad]; 0: the walk does not look
  double fallPitch = 0;    ///< [rad]; 0: the walk does not look
  double fallLead = 0.16;  ///< [s]

  // Torso
  double torsoMeasured = 0;      ///< share of its measured tilt that the legs are placed for
  double torsoRoll = 0;          ///< lean to the supporting leg in the middle of a step [rad]
  double constantHipHeight = 0;  ///< 1: the supporting hip keeps its height as it leans, 0: the mass does

  // Arms
  double armSwing = 0;          ///< shoulder pitch per distance of the feet along x [rad/m]
  double shoulderPitch = 1.57;  ///< [rad]
  double shoulderRoll = 0.25;   ///< outward [rad]
  double elbowYaw = 0;          ///< so that a bent elbow points outward [rad]
  double elbowRoll = 0.6;       ///< bent [rad]

  // Odometry: walked over planned
  double odometryDelay = 0.04;  ///< between a joint target and the measurement that shows it [s]
  double odometryMeasured = 0;  ///< share of the observed motion in it, where the feet's forces are felt
  double odometryForward = 1, odometrySideways = 1, odometryTurn = 1;

  /// Throws std::invalid_argument "walking parameter X = V must be A to B" for the first one out of its
  /// range.
  void check() const;
};

struct WalkParameterInfo {
  const char* name;  ///< as the member and the key in walking.yaml
  double WalkParameters::*value;
  double low, high;    ///< closed range
  bool blends = true;  ///< may differ between the directions of walking (WalkGaits)
};

/// Every member of WalkParameters.
std::span<const WalkParameterInfo> walkParameterTable();

}  // namespace plumbline::walking
