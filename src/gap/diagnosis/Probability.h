#pragma once
#include <vector>

#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

/// Samples per independent one: residuals of neighbours are alike.
constexpr double correlation = 8;

/// Most probable first: by how much worse each predicts what it was not fitted to, and by its prior.
/// left: squares beyond noise that remain in one direction of the data, whatever is chosen (see Merit.h);
/// what one candidate explains better than another may be of these.
void sortByProbability(std::vector<Candidate>& list, double left = 0);

/// A sum of squares for judging with what a cause's prior adds to it: of two causes, the lower is more
/// probable.
double withPrior(const Cause& cause, double judging);

/// Probability of each in a list sorted so, given that one of them is the cause.
std::vector<double> probabilities(const std::vector<Candidate>& list, double left = 0);

}  // namespace plumbline::gap
