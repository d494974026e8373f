#pragma once
#include <string>
#include <vector>

#include "gap/inference/Inference.h"

namespace plumbline::gap {

/// A hash of everything on which the searches of infer() depend: the robot's model, all that is in the
/// recordings, the options that matter, the library of effects, and the bytes of the running program. A
/// struct that gets a new member does not compile until the hash includes it.
std::string markOf(const Mechanism& robot, const std::vector<Trial>& trials, const InferenceOptions& options);

}  // namespace plumbline::gap
