#pragma once
#include <vector>

#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// What of a long recording is replayed: windows of 5 s spread evenly over it that together are about `most`
/// [s] long. It is the whole trial where that is no longer, or where its base is free: a body's way over the
/// ground cannot be begun from what is measured. The commands of 1.5 s before a window are played and not
/// compared: the joints forget how they began. Heat of before a window is not known in it.
std::vector<Trial> windowsOf(Trial trial, double most);

/// The same of each of several recordings that share `most` [s].
std::vector<std::vector<Trial>> windowsOf(std::vector<Trial> trials, double most);

}  // namespace plumbline::gap
