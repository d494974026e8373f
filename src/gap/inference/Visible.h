#pragma once
#include "gap/inference/Replayer.h"

namespace plumbline::gap {

/// Two engines that integrate one model differ by this share of a channel's noise (see Channels). What
/// changes every channel by less says how the replay is computed, and nothing about the robot.
constexpr double enginesDiffer = 0.5;

/// Whether a set replays otherwise with its i-th cause than without it, the values of the others held: in
/// some cell by a root mean square above enginesDiffer.
bool isVisible(const Replayer& replayer, const Explanation& causes, std::size_t i);

}  // namespace plumbline::gap
