#pragma once
#include <string>
#include <vector>

#include "gap/diagnosis/Diagnosis.h"
#include "gap/inference/StagedSearch.h"

namespace plumbline::gap {

/// The causes of a stage with intervals, probabilities, evidence and rivals; not what they close.
std::vector<Finding> findingsOf(const SearchStage& stage);

/// Of causes that gain in one recording alone: "... is supported by RECORDING alone".
std::vector<std::string> supportedByOne(const SearchStage& stage);

}  // namespace plumbline::gap
