#include "gap/run/ColumnStatistics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "math/Median.h"

namespace plumbline::gap {
namespace {

constexpr double ofNothing = std::numeric_limits<double>::quiet_NaN();  // a median

Likeness likeness(const std::vector<double>& a, const std::vector<double>& b) {
  Likeness result;
  result.pairs = a.size();
  if (a.empty()) return result;
  const double n = static_cast<double>(a.size());
  double meanA = 0, meanB = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) meanA += a[i] / n, meanB += b[i] / n;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = a[i] - meanA, y = b[i] - meanB;
    aa += x * x / n, bb += y * y / n, ab += x * y / n;
  }
  result.rmsA = std::sqrt(aa);
  result.rmsB = std::sqrt(bb);
  if (aa > 0 && bb > 0) result.correlation = ab / std::sqrt(aa * bb);
  std::vector<double> sorted = b;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t cut = sorted.size() / 100;
  result.rangeB = sorted[sorted.size() - 1 - cut] - sorted[cut];
  return result;
}

}  // namespace

std::string shownNumber(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", x);
  return buffer;
}

Extremes extremesOf(const std::vector<double>& column) {
  Extremes e{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double x : column) {
    if (std::isnan(x)) continue;
    e.low = std::min(e.low, x);
    e.high = std::max(e.high, x);
  }
  return e;
}

double lostShare(const std::vector<double>& column) {
  const auto lost = std::count_if(column.begin(), column.end(), [](double x) { return std::isnan(x); });
  return column.empty() ? 1 : static_cast<double>(lost) / static_cast<double>(column.size());
}

Following followingOf(const std::vector<double>& a, const std::vector<double>& b, double from) {
  std::vector<double> distance, size;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(std::abs(a[i]) > from) || std::isnan(b[i])) continue;
    distance.push_back(std::abs(b[i] - a[i]));
    size.push_back(std::abs(a[i]));
  }
  if (distance.empty()) return {};
  return {distance.size(), upperMedian(distance, ofNothing), upperMedian(size, ofNothing)};
}

double fastest(const std::vector<double>& t, const std::vector<double>& column, double jump) {
  double most = 0;
  std::size_t last = column.size();
  for (std::size_t i = 0; i < column.size(); ++i) {
    if (std::isnan(column[i])) continue;
    if (last < column.size())
      most = std::max(most, (std::abs(column[i] - column[last]) - jump) / (t[i] - t[last]));
    last = i;
  }
  return most;
}

double medianStep(const std::vector<double>& t) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < t.size(); ++i) steps.push_back(t[i] - t[i - 1]);
  return upperMedian(std::move(steps), ofNothing);
}

double medianLength(const std::vector<double>& x, const std::vector<double>& y,
                    const std::vector<double>& z) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double length = std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
    if (!std::isnan(length)) lengths.push_back(length);
  }
  return upperMedian(std::move(lengths), ofNothing);
}

double medianSum(const std::vector<const std::vector<double>*>& columns) {
  std::vector<double> sums;
  for (std::size_t i = 0; i < columns[0]->size(); ++i) {
    double sum = 0;
    for (const auto* column : columns) sum += (*column)[i];
    if (!std::isnan(sum)) sums.push_back(sum);
  }
  return upperMedian(std::move(sums), ofNothing);
}

Likeness likenessOf(const std::vector<double>& a, const std::vector<double>& b,
                    const std::vector<bool>& use) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!use[i] || std::isnan(a[i]) || std::isnan(b[i])) continue;
    x.push_back(a[i]);
    y.push_back(b[i]);
  }
  return likeness(x, y);
}

SpeedLikeness speedLikeness(const std::vector<double>& t, const std::vector<double>& position,
                            const std::vector<double>& speed, double period) {
  SpeedLikeness best;
  for (std::size_t lag = 0; lag <= 8; ++lag) {
    double xx = 0, yy = 0, xy = 0, n = 0;
    for (std::size_t i = 1; i + 1 + lag < t.size(); ++i) {
      const double step = t[i + 1] - t[i - 1], x = (position[i + 1] - position[i - 1]) / step,
                   y = speed[i + lag];
      if (step > 3 * period || std::isnan(x) || std::isnan(y)) continue;
      xx += x * x, yy += y * y, xy += x * y, ++n;
    }
    if (!(xx > 0) || !(yy > 0)) continue;
    const double correlation = xy / std::sqrt(xx * yy);
    if (best.rms > 0 && std::abs(correlation) <= std::abs(best.correlation)) continue;
    best = {correlation, xy / xx, std::sqrt(xx / n)};
  }
  return best;
}

Likeness tiltLikeness(const std::vector<double>& t, const std::vector<double>& side,
                      const std::vector<double>& up, const std::vector<double>& rate, double sign) {
  constexpr double window = 0.5;
  std::vector<double> a, b;
  double sumSide = 0, sumUp = 0, count = 0, turned = 0, half = 0, tiltBefore = 0,
         start = t.empty() ? 0 : t[0];
  bool hasBefore = false;
  double fromLastMiddle = 0;  // turned since the middle of the window before
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double step = t[i] - t[i - 1];
    if (!std::isnan(rate[i]) && step < window / 4) {
      turned += rate[i] * step;
      if (t[i] - start < window / 2) half = turned;
    }
    if (!std::isnan(side[i]) && !std::isnan(up[i])) sumSide += side[i], sumUp += up[i], ++count;
    if (t[i] - start < window) continue;
    if (count > 0) {
      const double tilt = sign * std::atan2(sumSide / count, sumUp / count);
      if (hasBefore) {
        a.push_back(tilt - tiltBefore);
        b.push_back(fromLastMiddle + half);
      }
      tiltBefore = tilt;
      hasBefore = true;
      fromLastMiddle = turned - half;
    }
    sumSide = sumUp = count = turned = half = 0;
    start = t[i];
  }
  return likeness(a, b);
}

}  // namespace plumbline::gap
