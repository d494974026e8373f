#pragma once
#include "gap/effects/Effect.h"

namespace plumbline::gap {

// One per file of this folder. A new effect: its file, its name here, its name in Effects.cpp.
extern const Effect commandDelay, commandDropout, servoGain, servoDamping, torqueLimit, speedLimit,
    coulombFriction, viscousFriction, stribeckFriction, loadFriction, backlash, jointCompliance,
    accelerationLimit, deadBand, supplyVoltage, biasForce, thermalDerating, rotorInertia, jointOffset,
    encoderNonlinearity, linkMass, comOffset, linkLength, imuMisalignment, gyroBias, imuDelay, fsrGain,
    groundFriction, groundSlope, groundCompliance, externalForce;

}  // namespace plumbline::gap
