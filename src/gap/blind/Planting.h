#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "gap/replay/Trial.h"
#include "gap/run/Run.h"

namespace plumbline::gap {

/// Recordings of a robot with its nominal model: what a diagnosis is given.
struct RealRecordings {
  Mechanism robot;
  std::vector<Run> runs;
  std::vector<Trial> trials;  ///< of the runs with the robot

  RealRecordings(Mechanism model, std::vector<Run> recordings);
};

/// Effects that can be planted exactly on any robot. They are taken out of the nominal model: a gain of 1.3
/// in reality is one divided by 1.3 in the model. Or the data is changed, if that is equivalent. Frictions,
/// play, compliance and lost commands are not among them, because the nominal model has none to take away.
inline constexpr std::string_view plantable[] = {
    "servo_gain",   "servo_damping", "rotor_inertia", "link_mass",   "com_offset", "link_length",
    "joint_offset", "command_delay", "torque_limit",  "speed_limit", "bias_force"};

/// Causes of these effects at all places of the robot that were recorded, each with one value per start of
/// its effect.
std::vector<Cause> plantsFor(const RealRecordings& base, std::span<const std::string_view> ids = plantable);

/// The recordings with the model that lacks the cause. Throws std::runtime_error where it cannot.
RealRecordings planted(const RealRecordings& base, const Cause& cause);

/// Residuals of all positions after 0.3 s, one after the other [rad]; NaN where nothing was measured.
std::vector<double> residualsOf(const RealRecordings& base, const Explanation& causes);

/// How many of these residuals a position of a trial has.
std::size_t residualCycles(const Trial& trial);

/// Root mean square of a - b over what is finite in both [rad].
double differenceOf(const std::vector<double>& a, const std::vector<double>& b);

/// The cause with the value that moves the residuals of the nominal model by so much [rad], within 40 %; its
/// value is nominal where none does.
Cause sized(const RealRecordings& base, Cause cause, double change);

/// Least that a cause, whatever its value, leaves of what the plant changes, as a share of the change: near 0
/// for the planted one in another name.
double leftOfPlant(const RealRecordings& base, const RealRecordings& planted, const Cause& cause);

}  // namespace plumbline::gap
