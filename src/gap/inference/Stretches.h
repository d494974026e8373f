#pragma once
#include <vector>

#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// First cycle of a trial that is scored: what came before the recording still rings for 0.3 s.
std::size_t firstScored(const Trial& trial);

/// Cuts the scored cycles of a trial into so many stretches, each of which holds as much of the trial's time
/// and of its travel, half and half. Travel: the ways of all commands and measured angles [rad, or m]. A
/// recording that rests after one step would else have one stretch that shows the step, and nothing to
/// predict that stretch from. Returns parts + 1 cycles in ascending order, from firstScored() to cycles().
std::vector<std::size_t> stretchesOf(const Trial& trial, std::size_t parts);

}  // namespace plumbline::gap
