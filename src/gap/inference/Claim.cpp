#include "gap/inference/Claim.h"

#include <algorithm>
#include <cmath>

#include "math/NormalDistribution.h"

namespace plumbline::gap {

namespace {

constexpr double meanSpread = 1;      // of the log share left, before any data
constexpr double motionSpread = 0.5;  // of it from motion to motion, likewise
constexpr double leastLeft = 0.02;    // share: less is noise

}  // namespace

double logLeft(double closed) { return std::log(std::max(leastLeft, 1 - closed)); }

Claim claimOf(const std::vector<double>& closedPerGroup, double bias) {
  if (closedPerGroup.empty()) return {};
  // A grid over the spread; given that, all is normal.
  constexpr int points = 60;
  constexpr double farthest = 4;  // of motionSpread
  struct Point {
    double weight, mean, deviation;
  };
  std::vector<Point> grid;
  const auto n = static_cast<double>(closedPerGroup.size());
  std::vector<double> left;
  for (const double closed : closedPerGroup) left.push_back(logLeft(closed) + bias);
  double sum = 0, best = -HUGE_VAL;
  for (const double x : left) sum += x;
  for (int i = 0; i < points; ++i) {
    const double spread = motionSpread * farthest * (i + 0.5) / points, square = spread * spread;
    const double precision = 1 / (meanSpread * meanSpread) + n / square;
    const double mean = sum / square / precision;
    double exponent = -spread * spread / (2 * motionSpread * motionSpread) - n * std::log(spread) -
                      std::log(precision) / 2 + mean * mean * precision / 2;
    for (const double x : left) exponent -= x * x / (2 * square);
    best = std::max(best, exponent);
    grid.push_back({exponent, mean, std::sqrt(square + 1 / precision)});
  }
  double all = 0, expected = 0;
  for (Point& point : grid) all += point.weight = std::exp(point.weight - best);
  for (const Point& point : grid)
    expected += point.weight / all * std::exp(point.mean + point.deviation * point.deviation / 2);
  const auto quantile = [&](double share) {
    double low = -20, high = 20;
    for (int round = 0; round < 60; ++round) {
      const double x = (low + high) / 2;
      double below = 0;
      for (const Point& point : grid)
        below += point.weight / all * shareBelow((x - point.mean) / point.deviation);
      (below < share ? low : high) = x;
    }
    return (low + high) / 2;
  };
  constexpr double tail = 0.05;
  return {1 - expected, 1 - std::exp(quantile(1 - tail)), 1 - std::exp(quantile(tail))};
}

std::vector<double> closedPerGroup(const std::vector<RecordingLeft>& leftOut,
                                   const std::vector<std::size_t>& groupOfRecording) {
  std::vector<double> sums, counts;
  for (std::size_t i = 0; i < leftOut.size(); ++i) {
    const std::size_t group = groupOfRecording[i];
    if (sums.size() <= group) sums.resize(group + 1, 0), counts.resize(group + 1, 0);
    // A recording without a gap cannot show which share of it closes.
    if (!leftOut[i].showsGap()) continue;
    sums[group] += leftOut[i].closedToNoise();
    ++counts[group];
  }
  std::vector<double> means;
  for (std::size_t g = 0; g < sums.size(); ++g)
    if (counts[g] > 0) means.push_back(sums[g] / counts[g]);
  return means;
}

}  // namespace plumbline::gap
