#pragma once
#include <vector>

#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

/// Samples per independent one: residuals of neighbours are alike.
constexpr double correlation = 8;

/// Most probable first: by how much worse each predicts what it was not fitted to, and by its prior.
void sortByProbability(std::vector<Candidate>& list);

/// A sum of squares for judging with what a cause's prior adds to it: of two causes, the lower is more
/// probable.
double withPrior(const Cause& cause, double judging);

/// Probability of each in a sorted list, given that one of them is the cause.
std::vector<double> probabilities(const std::vector<Candidate>& list);

}  // namespace plumbline::gap
