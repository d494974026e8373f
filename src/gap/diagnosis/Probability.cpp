#include "gap/diagnosis/Probability.h"

#include <algorithm>
#include <cmath>

namespace plumbline::gap {

namespace {

constexpr double engineShare = 0.0007;  // of a sum of squares

/// Every effect is as likely as any other before the data; one whose value can lie on either side of nominal
/// shares that between the sides, one with an axis has a third for each.
double logPrior(const Cause& cause) {
  const Effect& e = *cause.effect;
  const bool twoSided = e.lower < e.nominal && e.nominal < e.upper;
  const double side = !twoSided ? 1 : cause.value < e.nominal ? e.belowShare : 1 - e.belowShare;
  return std::log(side / (e.hasAxis ? 3 : 1));
}

/// What a sum of squares has to differ by for a nat of evidence: samples are correlated, and where two causes
/// come within a thousandth of each other, the engines' own difference may decide.
double temperature(double judging, double left) { return 2 * (correlation + engineShare * judging + left); }

double temperatureOf(const std::vector<FittedCause>& list, double left) {
  double best = INFINITY;
  for (const FittedCause& c : list) best = std::min(best, c.fit.judging);
  return temperature(best, left);
}

double logWeight(const FittedCause& c, double temperature) {
  return logPrior(c.cause) - c.fit.judging / temperature;
}

}  // namespace

void sortByProbability(std::vector<FittedCause>& list, double left) {
  const double t = temperatureOf(list, left);
  std::stable_sort(list.begin(), list.end(), [t](const FittedCause& a, const FittedCause& b) {
    return logWeight(a, t) > logWeight(b, t);
  });
}

double withPrior(const Cause& cause, double judging) {
  return judging - temperature(judging, 0) * logPrior(cause);
}

std::vector<double> probabilities(const std::vector<FittedCause>& list, double left) {
  std::vector<double> result;
  if (list.empty()) return result;
  const double t = temperatureOf(list, left), most = logWeight(list.front(), t);
  double sum = 0;
  for (const FittedCause& c : list) sum += result.emplace_back(std::exp(logWeight(c, t) - most));
  for (double& p : result) p /= sum;
  return result;
}

}  // namespace plumbline::gap
