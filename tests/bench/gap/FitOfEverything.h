#pragma once
#include "ChainReplay.h"

namespace plumbline::bench {

/// The usual way to identify a simulator's parameters: one CMA-ES fit of one value per effect of the library.
/// An effect is at the joint with the largest gap, or the link that it moves, the whole robot, or the
/// inertial sensor. A small penalty pulls values to nominal; the largest deviation relative to its bounds is
/// named. Empty where that lowers the squares by less than a tenth. Lost commands have no value to fit;
/// external forces, feet and ground stay out, as no run on the feet is replayed.
gap::Explanation fitOfEverything(const Mechanism& robot, const ChainReplay& chain, bool imuRecorded,
                                 int jobs);

}  // namespace plumbline::bench
