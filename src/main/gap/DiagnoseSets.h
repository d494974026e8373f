#pragma once
#include <functional>
#include <string>
#include <vector>

#include "gap/answer/Answer.h"
#include "gap/replay/Trial.h"
#include "main/gap/Timing.h"

namespace plumbline::gap {

/// How bin/gap diagnose --method sets was asked.
struct SetsRequest {
  const Mechanism& robot;
  std::string json, timing;
  int jobs = 1, maxCauses = 0;
  bool quiet = false;
};

/// Diagnoses by sets of causes that are judged on recordings left out, and writes the answer. separating: the
/// motion that separates a diagnosis's likeliest rival, in words.
void diagnoseBySets(const SetsRequest& request, std::vector<Trial> trials, AnswerInput input,
                    const Timing& timing,
                    const std::function<std::string(const Mechanism&, const Diagnosis&)>& separating);

}  // namespace plumbline::gap
