#pragma once
#include "parameters/Parameter.h"

namespace plumbline::walking {

/// Feedback from the torso's angle and turn rate; zero is the open loop.
struct FeedbackParameters {
  PARAMETERS(FeedbackParameters)
  PARAMETER(double, delay, 0.04, "s", Range(0, 0.1), "from a measurement to the effect of its command",
            "blends")
  PARAMETER(double, tiltWindow, 0, "s", Range(0, 100),
            "time after which a constant tilt counts as usual, 0: never")
  PARAMETER(double, ankleRollGain, 0, "", Range(-2, 2), "torso angle to the supporting ankle", "blends",
            "feedback")
  PARAMETER(double, anklePitchGain, 0, "", Range(-2, 2), "torso angle to the supporting ankle", "blends",
            "feedback")
  PARAMETER(double, ankleRollRate, 0, "s", Range(-0.5, 0.5), "torso turn rate to the supporting ankle",
            "blends", "feedback")
  PARAMETER(double, anklePitchRate, 0, "s", Range(-0.5, 0.5), "torso turn rate to the supporting ankle",
            "blends", "feedback")
  PARAMETER(double, stepForwardGain, 0, "", Range(-2, 3),
            "share of the tilt that step planning interprets as motion of the pendulum", "blends", "feedback")
  PARAMETER(double, stepSidewaysGain, 0, "", Range(-2, 3),
            "share of the tilt that step planning interprets as motion of the pendulum", "blends", "feedback")
  PARAMETER(double, swingLevel, 0, "", Range(0, 1.5),
            "share of the tilt that the swing foot is turned back by", "blends", "feedback")
  PARAMETER(double, hipRollGain, 0, "", Range(-2, 2), "torso angle to the supporting hip (section 4.2.7)",
            "blends", "feedback")
  PARAMETER(double, hipPitchGain, 0, "", Range(-2, 2), "torso angle to the supporting hip (section 4.2.7)",
            "blends", "feedback")
  PARAMETER(double, hipRollRate, 0, "s", Range(-0.5, 0.5), "torso turn rate to the supporting hip", "blends",
            "feedback")
  PARAMETER(double, hipPitchRate, 0, "s", Range(-0.5, 0.5), "torso turn rate to the supporting hip", "blends",
            "feedback")
  PARAMETER(double, comForwardGain, 0, "", Range(-2, 3),
            "share of the tilt that the mass is moved back over the feet by", "blends", "feedback")
  PARAMETER(double, comSidewaysGain, 0, "", Range(-2, 3),
            "share of the tilt that the mass is moved back over the feet by", "blends", "feedback")
  PARAMETER(double, tiltTolerance, 0.2, "rad", Range(0, 2),
            "torso's deviation from its plan beyond which the walk slows down", "blends")
  PARAMETER(double, tiltBrake, 0, "1/rad", Range(0, 50),
            "share by which the requested speed is reduced per such deviation", "blends", "feedback")
  PARAMETER(double, swingMeasuredPitch, 0, "", Range(-1, 2),
            "share of the measured pitch that the swing foot is placed for", "blends", "feedback")
  PARAMETER(double, swingMeasuredRoll, 0, "", Range(-1, 2),
            "share of the measured roll that the swing foot is placed for", "blends", "feedback")
  PARAMETER(double, torsoMeasured, 0, "", Range(-1, 2),
            "share of the torso's measured tilt that the legs are placed for", "blends", "feedback")
};

/// Observation of the walk state (section 4.2.5); both gains 0: it follows the model alone.
struct ObservationParameters {
  PARAMETERS(ObservationParameters)
  PARAMETER(double, delay, 0.04, "s", Range(0.001, 0.2), "from a command to the measurement that shows it")
  PARAMETER(double, positionGain, 0, "", Range(0, 1),
            "share of the observed error of the feet that is corrected in a cycle", "blends", "feedback")
  PARAMETER(double, velocityGain, 0, "", Range(0, 1),
            "share of the observed error of the velocity that is corrected in a cycle", "blends", "feedback")
  PARAMETER(double, positionGainLateral, 1, "", Range(0, 2), "times positionGain: sideways", "blends")
  PARAMETER(double, velocityGainLateral, 1, "", Range(0, 2), "times velocityGain: sideways", "blends")
  PARAMETER(double, imuWindow, 0, "s", Range(0, 100),
            "time over which IMU and legs are compared, 0: the IMU is right")
  PARAMETER(double, biasWindow, 0, "s", Range(0, 100),
            "time after which a constant error of the model counts as usual, 0: never")
};

/// Recovery from a push, by how far the capture point is off its usual place (Disturbance).
struct RecoveryParameters {
  PARAMETERS(RecoveryParameters)
  PARAMETER(double, from, 0.03, "m", Range(0, 1), "from here on the walk recovers (gaits.recovery)", "blends")
  PARAMETER(double, full, 0, "m", Range(0, 1),
            "from here on it does nothing else; not above recovery.from: it never recovers", "blends")
  PARAMETER(double, fadeTime, 0.5, "s", Range(0, 10), "until it walks as before")
  PARAMETER(double, captureMargin, 1, "m", Range(-0.05, 1),
            "standing: steps when the capture point is so far outside the soles")
};

/// Force sensors: when a step ends (SupportSwitch).
struct ContactParameters {
  PARAMETERS(ContactParameters)
  PARAMETER(double, share, 0, "", Range(0, 1),
            "share of the weight on the swing foot that makes it carry, 0: steps end as planned", "blends",
            "feedback")
  PARAMETER(double, minPhase, 0.7, "", Range(0.1, 1), "share of the step before which it does not end",
            "blends")
  PARAMETER(double, maxWait, 0, "s", Range(0, 0.2),
            "longest extension of a step if the foot has not reached the ground", "blends")
};

/// A fall that cannot be stopped any more (FallGuard).
struct FallParameters {
  PARAMETERS(FallParameters)
  PARAMETER(double, roll, 0, "rad", Range(0, 2),
            "limit of the torso's roll plus lead times its rate, 0: the walk does not look")
  PARAMETER(double, pitch, 0, "rad", Range(0, 2),
            "limit of the torso's pitch plus lead times its rate, 0: the walk does not look")
  PARAMETER(double, lead, 0.16, "s", Range(0, 1), "time by which the torso's angle is extrapolated")
};

struct OdometryParameters {
  PARAMETERS(OdometryParameters)
  PARAMETER(double, delay, 0.04, "s", Range(0, 0.2), "from a joint target to the measurement that shows it")
  PARAMETER(double, observedShare, 0, "", Range(0, 1),
            "share of the observed motion, if the feet have force sensors")
  PARAMETER(double, scaleForward, 1, "", Range(0.1, 3), "walked over planned", "blends")
  PARAMETER(double, scaleSideways, 1, "", Range(0.1, 3), "walked over planned", "blends")
  PARAMETER(double, scaleTurn, 1, "", Range(0.1, 3), "turned over planned", "blends")
};

}  // namespace plumbline::walking
