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

/// Phase of every cycle for one signal. Of a joint: reversal within 0.15 s of a change of direction, high
/// speed above half of the joint's limit, high load where the servo's error asks for half of its torque or
/// more, static where neither command nor joint moves, motion otherwise. Of the body: the foot that carries
/// more than 80 % of the weight, impact where the force on a foot jumps.
std::vector<Phase> phasesOf(const Trial& trial, const Signal& signal);

}  // namespace plumbline::gap
