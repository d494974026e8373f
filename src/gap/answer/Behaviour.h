#pragma once
#include <string>
#include <vector>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// One thing that a robot on its feet did, as measured and as two models play it from the first command on
/// with nothing put right on the way (free run). NaN where a run cannot tell.
struct Behaviour {
  std::string what, unit;
  double measured = 0, nominal = 0, corrected = 0;
};

/// Of every run with a free base: how its torso swayed and tilted, how its weight lay on the feet, how far
/// and how fast it went where an outside system saw it, whether it fell. nominal: predictions per trial;
/// corrected: the evaluator's base.
std::vector<Behaviour> behaviours(const Evaluator& evaluator, const std::vector<Prediction>& nominal);

}  // namespace plumbline::gap
