#include "gap/inference/Likelihood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "gap/replay/DoublePair.h"

namespace plumbline::gap {

namespace {

/// Sum of s / (freedom + s / square), in the order of the values; the divisions two at once.
double sumOfBounded(const std::vector<double>& values, double square) {
  double sum = 0;
  std::size_t k = 0;
  for (; k + 1 < values.size(); k += 2) {
    const auto s = readDoubles<DoublePair>(values.data() + k);
    const DoublePair bounded = s / (tailFreedom + s / square);
    sum += bounded[0];
    sum += bounded[1];
  }
  if (k < values.size()) sum += values[k] / (tailFreedom + values[k] / square);
  return sum;
}

constexpr std::size_t lagsAtOnce = 8;

/// Sums of x[k] * x[k - lag] for as many lags from a first one on, each in the order of k.
std::array<double, lagsAtOnce> laggedProducts(const std::vector<double>& x, std::size_t first) {
  const std::size_t n = x.size(), last = first + lagsAtOnce - 1;
  std::array<double, lagsAtOnce> sums{};
  for (std::size_t i = 0; i < lagsAtOnce; ++i)
    for (std::size_t k = first + i; k < std::min(last, n); ++k) sums[i] += x[k] * x[k - first - i];
  // Each pair has the larger lag first, as the values lie.
  DoublePair a{sums[1], sums[0]}, b{sums[3], sums[2]}, c{sums[5], sums[4]}, d{sums[7], sums[6]};
  for (std::size_t k = last; k < n; ++k) {
    const double* before = x.data() + (k - last);
    const double here = x[k];
    a += here * readDoubles<DoublePair>(before + 6);
    b += here * readDoubles<DoublePair>(before + 4);
    c += here * readDoubles<DoublePair>(before + 2);
    d += here * readDoubles<DoublePair>(before);
  }
  return {a[1], a[0], b[1], b[0], c[1], c[0], d[1], d[0]};
}

}  // namespace

double likeliestScale(const std::vector<double>& residuals, double least) {
  constexpr int rounds = 60;
  constexpr double maxChange = 1e-4;  // of the square, as a share of it, in the last round
  std::vector<double> squared;
  squared.reserve(residuals.size());
  double squares = 0;
  for (const double r : residuals)
    if (std::isfinite(r)) squares += squared.emplace_back(r * r);
  if (squared.empty()) return least;
  const auto n = static_cast<double>(squared.size());
  double square = std::max(squares / n, least * least);
  for (int round = 0; round < rounds; ++round) {
    const double sum = sumOfBounded(squared, square);
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
  double variance = 0;
  for (const double of : x) variance += of * of;
  if (n < 4 || !(variance > 0)) return 1;
  double sum = 0;
  std::array<double, lagsAtOnce> covariances{};
  for (std::size_t lag = 1; lag + 1 < n / 2; lag += 2) {
    const std::size_t at = (lag - 1) % lagsAtOnce;
    if (at == 0) covariances = laggedProducts(x, lag);
    const double pair = (covariances[at] + covariances[at + 1]) / variance;
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
