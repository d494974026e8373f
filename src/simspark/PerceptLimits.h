#pragma once
#include <string>

#include "simspark/ServerMessage.h"

namespace plumbline::simspark {

// Limits of what a robot on a field can measure. They are far wider than anything a server sends, and narrow
// enough that no filter overflows; a value beyond them is the sender's error.
constexpr double maxServerTime = 1e9;                 ///< [s]
constexpr double maxSeenDistance = 200;               ///< [m]
constexpr double maxJointAngle = 6.2831853071795865;  ///< a whole turn either way [rad]; of bearings, too
constexpr double maxTurnRate = 200;                   ///< [rad/s]
constexpr double maxAcceleration = 2000;              ///< [m/s^2]
constexpr double maxForce = 1e5;                      ///< [N]
constexpr double maxForcePoint = 2;                   ///< from the foot's centre [m]
constexpr double maxTrueDistance = 1000;              ///< of the true state from the field's centre [m]

/// Removes values beyond the limits from a message: percepts, heard messages, the true state and angles are
/// removed; gyro, accelerometer, forces and game clock keep the previous message's values. Returns the
/// number, and names the first.
int dropImplausible(ServerMessage& message, const ServerMessage& before, std::string& first);

}  // namespace plumbline::simspark
