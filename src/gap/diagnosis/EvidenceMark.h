#pragma once
#include <string>

#include "gap/diagnosis/Diagnosis.h"

namespace plumbline::gap {

/// A hash of all that a diagnosis' searches depend on: the robot's whole model, every number of the
/// recordings with the noise they are judged by, the steps of the replays, the options that decide, the
/// library of effects, and the running program's own bytes. What a member is added to does not compile until
/// the member is in.
std::string markOf(const Evaluator& evaluator, const DiagnosisOptions& options);

}  // namespace plumbline::gap
