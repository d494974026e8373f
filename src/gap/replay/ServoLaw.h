#pragma once
#include "gap/replay/Plant.h"

namespace plumbline::gap {

/// A servo's torque near a state: tau = torque - stiffness x - damping w, for the position x it turns and the
/// speed w there. regime tells which branch of the law holds, so that a solver notices when it changes.
struct ServoLine {
  double torque = 0;     ///< [N m]
  double stiffness = 0;  ///< [N m/rad]
  double damping = 0;    ///< [N m s/rad]
  int regime = 0;

  double at(double x, double w) const { return torque - stiffness * x - damping * w; }
};

/// Angle that the encoder reports for a true one.
double measuredAngle(const JointPlant& plant, double angle);

/// The contract's servo laws (position and dc_motor) with what effects change in them.
/// command [rad]; share: stiffness 0..1; volts: measured supply, 0: the table's; x: true angle on the
/// encoder's side, w: its speed; limitShare: share of the torque limit that heat has left; supplyShare: of
/// the supply that the load has left, where it is not measured; speed, torque: sent beside the command, which
/// a DC motor's law has no use for [rad/s, N m].
ServoLine servoLine(const JointPlant& plant, double command, double share, double volts, double x, double w,
                    double limitShare, double supplyShare = 1, double speed = 0, double torque = 0);

/// Share of the supply, -1..1, that a DC motor's servo puts on it for a command and the angle that its
/// encoder shows [rad]; NaN for other servos.
double dutyOf(const JointPlant& plant, double command, double shown);

}  // namespace plumbline::gap
