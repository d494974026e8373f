#pragma once
#include <vector>

#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

/// Samples per independent one: residuals of neighbours are alike.
constexpr double correlation = 8;

/// Sorts by probability, highest first: by the prediction of data that was not fitted, and by the prior.
/// left: squares beyond noise that remain per direction of the data, whatever is chosen (see
/// AcceptanceTest.h); a difference between two candidates may come from these.
void sortByProbability(std::vector<FittedCause>& list, double left = 0);

/// A sum of squares for judging plus the term for a cause's prior: the cause with the lower sum is more
/// probable.
double withPrior(const Cause& cause, double judging);

/// Probability of each in a list sorted so, given that one of them is the cause.
std::vector<double> probabilities(const std::vector<FittedCause>& list, double left = 0);

}  // namespace plumbline::gap
