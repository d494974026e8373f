#pragma once
#include <nlohmann/json.hpp>

#include "gap/answer/Answer.h"
#include "gap/inference/AllJointFit.h"
#include "gap/inference/Inference.h"

namespace plumbline::gap {

/// The answer of a diagnosis by sets, as answer.json has it: what every answer has, and what each recording
/// left out says. `further` is what a fit of all joints closes beyond the causes; null if it was not made.
nlohmann::json setsAnswer(const Inference& inference, const AllJointFit& further, const AnswerInput& input,
                          const Evidence& evidence, const Mechanism& robot);

}  // namespace plumbline::gap
