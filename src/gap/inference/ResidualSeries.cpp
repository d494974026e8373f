#include "gap/inference/ResidualSeries.h"

#include <algorithm>
#include <cmath>

#include "gap/inference/Likelihood.h"

namespace plumbline::gap {

double StretchFit::meanScale(double share) const { return scaleOfMean(mean, noise, scale, share * samples); }

double StretchFit::density(double share) const {
  return share * about + logDensity({mean}, meanScale(share));
}

std::vector<double> ResidualSeries::stretch(std::size_t from, std::size_t to) const {
  to = std::min(to, values_.size());
  if (from >= to) return {};
  return {values_.begin() + static_cast<std::ptrdiff_t>(from),
          values_.begin() + static_cast<std::ptrdiff_t>(to)};
}

StretchFit ResidualSeries::fitOf(std::size_t from, std::size_t to, double noise) const {
  const std::lock_guard lock(mutex_);
  for (const Kept& of : fits_)
    if (of.from == from && of.to == to && of.noise == noise) return of.fit;
  const Split parts = split(stretch(from, to));
  StretchFit fit;
  fit.scale = likeliestScale(parts.about, noise);
  fit.about = logDensity(parts.about, fit.scale);
  fit.mean = parts.mean;
  fit.noise = noise;
  fit.samples =
      static_cast<double>(std::ranges::count_if(parts.about, [](double r) { return std::isfinite(r); }));
  fits_.push_back({from, to, noise, fit});
  return fit;
}

double ResidualSeries::correlationOf(std::size_t from, std::size_t to) const {
  const std::lock_guard lock(mutex_);
  for (const KeptTime& of : times_)
    if (of.from == from && of.to == to) return of.time;
  times_.push_back({from, to, correlationTime(stretch(from, to))});
  return times_.back().time;
}

}  // namespace plumbline::gap
