#pragma once
#include <string>

#include "gap/diagnosis/Diagnosis.h"

namespace plumbline::gap {

/// A hash of everything on which a diagnosis' searches depend: the robot's model, all numbers of the
/// recordings and their noise, and the steps of the replays. It also includes the options that matter, the
/// library of effects, and the bytes of the running program. A struct that gets a new member does not compile
/// until the hash includes it.
std::string markOf(const Evaluator& evaluator, const DiagnosisOptions& options);

}  // namespace plumbline::gap
