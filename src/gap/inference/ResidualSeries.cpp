#include "gap/inference/ResidualSeries.h"

#include <algorithm>
#include <cmath>

#include "gap/inference/Likelihood.h"

namespace plumbline::gap {

std::vector<double> ResidualSeries::stretch(std::size_t from, std::size_t to) const {
  to = std::min(to, values.size());
  if (from >= to) return {};
  return {values.begin() + static_cast<std::ptrdiff_t>(from),
          values.begin() + static_cast<std::ptrdiff_t>(to)};
}

StretchFit ResidualSeries::fitOf(std::size_t from, std::size_t to, double noise) const {
  const std::lock_guard lock(mutex);
  for (const Kept& of : fits)
    if (of.from == from && of.to == to && of.noise == noise) return of.fit;
  const Split parts = split(stretch(from, to));
  StretchFit fit;
  fit.scale = likeliestScale(parts.about, noise);
  fit.about = logDensity(parts.about, fit.scale);
  fit.mean = logDensity({parts.mean}, std::max(noise, std::abs(parts.mean)));
  fits.push_back({from, to, noise, fit});
  return fit;
}

double ResidualSeries::correlationOf(std::size_t from, std::size_t to) const {
  const std::lock_guard lock(mutex);
  for (const KeptTime& of : times)
    if (of.from == from && of.to == to) return of.time;
  times.push_back({from, to, correlationTime(stretch(from, to))});
  return times.back().time;
}

}  // namespace plumbline::gap
