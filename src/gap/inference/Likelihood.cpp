#include "gap/inference/Likelihood.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumbline::gap {

double likeliestScale(const std::vector<double>& residuals, double least) {
  constexpr int rounds = 60;
  constexpr double maxChange = 1e-4;  // of the square, as a share of it, in the last round
  double squares = 0, n = 0;
  for (const double r : residuals)
    if (std::isfinite(r)) squares += r * r, ++n;
  if (n == 0) return least;
  double square = std::max(squares / n, least * least);
  for (int round = 0; round < rounds; ++round) {
    double sum = 0;
    for (const double r : residuals)
      if (std::isfinite(r)) sum += r * r / (tailFreedom + r * r / square);
    const double next = std::max((tailFreedom + 1) * sum / n, least * least);
    const bool done = std::abs(next - square) <= maxChange * square;
    square = next;
    if (done) break;
  }
  return std::sqrt(square);
}

double logDensity(const std::vector<double>& residuals, double scale) {
  const double constant = std::lgamma((tailFreedom + 1) / 2) - std::lgamma(tailFreedom / 2) -
                          std::log(tailFreedom * std::numbers::pi) / 2 - std::log(scale);
  double sum = 0;
  for (const double r : residuals)
    if (std::isfinite(r))
      sum += constant - (tailFreedom + 1) / 2 * std::log1p(r * r / (tailFreedom * scale * scale));
  return sum;
}

Split split(const std::vector<double>& residuals) {
  Split parts{0, residuals};
  double n = 0;
  for (const double r : residuals)
    if (std::isfinite(r)) parts.mean += r, ++n;
  if (n > 0) parts.mean /= n;
  for (double& r : parts.about) r -= parts.mean;
  return parts;
}

double scaleOfMean(double mean, double noise, double variation, double independent) {
  return std::max({noise, std::abs(mean), variation / std::sqrt(std::max(1.0, independent))});
}

double StretchFit::meanScale(double share) const { return scaleOfMean(mean, noise, scale, share * samples); }

double StretchFit::density(double share) const {
  return share * about + logDensity({mean}, meanScale(share));
}

StretchFit fitStretch(const Split& residuals, double noise) {
  StretchFit fit;
  fit.scale = likeliestScale(residuals.about, noise);
  fit.about = logDensity(residuals.about, fit.scale);
  fit.mean = residuals.mean;
  fit.noise = noise;
  fit.samples =
      static_cast<double>(std::ranges::count_if(residuals.about, [](double r) { return std::isfinite(r); }));
  return fit;
}

double correlationTime(const std::vector<double>& residuals) {
  std::vector<double> x = split(residuals).about;
  for (double& r : x)
    if (!std::isfinite(r)) r = 0;
  const std::size_t n = x.size();
  const auto covariance = [&](std::size_t lag) {
    double sum = 0;
    for (std::size_t k = lag; k < n; ++k) sum += x[k] * x[k - lag];
    return sum;
  };
  const double variance = covariance(0);
  if (n < 4 || !(variance > 0)) return 1;
  double sum = 0;
  for (std::size_t lag = 1; lag + 1 < n / 2; lag += 2) {
    const double pair = (covariance(lag) + covariance(lag + 1)) / variance;
    if (pair <= 0) break;
    sum += pair;
  }
  return std::max(1.0, 1 + 2 * sum);
}

double timeOfScale(double correlationTime, double scale, double noise) {
  const double known = noise / scale;
  return 1 + (correlationTime - 1) * std::max(0.0, 1 - known * known);
}

}  // namespace plumbline::gap
