#pragma once
#include "ChainReplay.h"

namespace plumbline::bench {

/// The usual way to identify a simulator's parameters: one CMA-ES fit of one value per effect of the library
/// (at the joint with the largest gap, or the link that it moves, the whole robot, the inertial sensor),
/// pulled to nominal by a small penalty; what deviates most in shares of its bounds is named. Empty where
/// that lowers the squares by less than a tenth. Lost commands have no value to fit; external forces, feet
/// and ground stay out, as no run on the feet is replayed.
gap::Explanation fitOfEverything(const Mechanism& robot, const ChainReplay& chain, bool imuRecorded,
                                 int jobs);

}  // namespace plumbline::bench
