#pragma once
#include <cstddef>
#include <string_view>
#include <vector>

#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// What a joint, or the robot, is doing in a cycle.
enum class Phase { staticHold, reversal, highSpeed, highLoad, impact, leftSupport, rightSupport, motion };
inline constexpr std::size_t numPhases = 8;
std::string_view nameOf(Phase phase);  ///< "static hold", "reversal", ...

/// Phase of every cycle for one signal. For a joint: reversal within 0.15 s of a change of direction, high
/// speed above half of the joint's limit, high load if the servo's error requests half of its torque or more.
/// Static if neither command nor joint moves, motion otherwise. For the body: the foot that carries more than
/// 80 % of the weight, impact when the force on a foot jumps.
std::vector<Phase> phasesOf(const Trial& trial, const Signal& signal);

}  // namespace plumbline::gap
