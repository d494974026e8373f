#pragma once
#include <string>

#include "simspark/ServerMessage.h"

namespace plumbline::simspark {

// What a robot on a field can measure. Far wider than anything a server sends, narrow enough that no filter
// overflows: beyond it the sender is at fault.
constexpr double maxServerTime = 1e9;                 ///< [s]
constexpr double maxSeenDistance = 200;               ///< [m]
constexpr double maxJointAngle = 6.2831853071795865;  ///< a whole turn either way [rad]; of bearings, too
constexpr double maxTurnRate = 200;                   ///< [rad/s]
constexpr double maxAcceleration = 2000;              ///< [m/s^2]
constexpr double maxForce = 1e5;                      ///< [N]
constexpr double maxForcePoint = 2;                   ///< from the foot's centre [m]
constexpr double maxTrueDistance = 1000;              ///< of the true state from the field's centre [m]

/// Takes out of a message what is beyond: seen and heard things and the true state go, an angle is not there,
/// gyro, accelerometer, forces and game clock are those of the message before. Returns how many, and names
/// the first.
int dropImplausible(ServerMessage& message, const ServerMessage& before, std::string& first);

}  // namespace plumbline::simspark
