#pragma once
#include <string>
#include <vector>

#include "gap/answer/Answer.h"
#include "gap/replay/Trial.h"
#include "main/gap/Timing.h"

namespace plumbline::gap {

/// Options of bin/gap diagnose --method sets.
struct SetsRequest {
  const Mechanism& robot;
  std::string json, timing;
  std::string memory;  ///< file that a stopped diagnosis continues from; empty: none
  int jobs = 1, maxCauses = 0;
  bool quiet = false;
};

/// Diagnoses by sets of causes that are judged on recordings left out, and writes the answer.
void diagnoseBySets(const SetsRequest& request, std::vector<Trial> trials, AnswerInput input,
                    const Timing& timing);

}  // namespace plumbline::gap
