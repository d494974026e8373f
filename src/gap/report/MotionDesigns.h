#pragma once
#include <vector>

#include "gap/record/Excitation.h"

namespace plumbline::gap {

/// Programs for a robot with a fixed base that move some of its joints, each for one purpose and in several
/// sizes. There are slow triangles, small reversals at several gravity loadings, chirps, steps, fast moves,
/// multisines and static poses. About 14 s long, within the limits of position and speed.
std::vector<Excitation> motionDesigns(const Mechanism& robot, const std::vector<int>& joints);

}  // namespace plumbline::gap
