#pragma once
#include <cstdint>
#include <vector>

#include "gap/inference/Score.h"

namespace plumbline::gap {

/// Probabilities of sets that were scored on the same groups: softmax of score, averaged over how much each
/// group counts. This is the Bayesian bootstrap over groups (Yao, Vehtari, Simpson and Gelman, "Using
/// stacking to average Bayesian predictive distributions", Bayesian Analysis 13, 2018). Seeded; in order of
/// the sets.
std::vector<double> posterior(const std::vector<Scored>& sets, std::uint64_t seed = 1);

/// Sum over the sets that hold a cause of the same effect and place.
double probabilityOf(const Cause& cause, const std::vector<Scored>& sets, const std::vector<double>& p);

}  // namespace plumbline::gap
