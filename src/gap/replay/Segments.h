#pragma once
#include <vector>

#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// The parts of a long recording that are replayed: segments of 5 s spread evenly over it, together about
/// `most` [s] long. A shorter trial is used completely, and so is one with a free base, because the
/// measurements do not give the state from which a body's motion could start. The commands of 1.5 s before a
/// segment are played but not compared, so the initial state of the joints has no effect. Heat from before a
/// segment is unknown.
std::vector<Trial> segmentsOf(Trial trial, double most);

/// The same for several recordings that share `most` [s].
std::vector<std::vector<Trial>> segmentsOf(std::vector<Trial> trials, double most);

}  // namespace plumbline::gap
