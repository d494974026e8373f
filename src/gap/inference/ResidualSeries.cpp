#include "gap/inference/ResidualSeries.h"

#include <algorithm>

namespace plumbline::gap {

std::vector<double> ResidualSeries::stretch(std::size_t from, std::size_t to) const {
  to = std::min(to, values_.size());
  if (from >= to) return {};
  return {values_.begin() + static_cast<std::ptrdiff_t>(from),
          values_.begin() + static_cast<std::ptrdiff_t>(to)};
}

StretchFit ResidualSeries::fitOf(std::size_t from, std::size_t to, double noise) const {
  const std::lock_guard lock(mutex_);
  for (const Kept& of : fits_)
    if (of.from == from && of.to == to && of.fit.noise == noise) return of.fit;
  fits_.push_back({from, to, fitStretch(split(stretch(from, to)), noise)});
  return fits_.back().fit;
}

double ResidualSeries::correlationOf(std::size_t from, std::size_t to) const {
  const std::lock_guard lock(mutex_);
  for (const KeptTime& of : times_)
    if (of.from == from && of.to == to) return of.time;
  times_.push_back({from, to, correlationTime(stretch(from, to))});
  return times_.back().time;
}

}  // namespace plumbline::gap
