#include "gap/diagnosis/LossResponse.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "gap/replay/Replay.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t samples = 4;     // replays, each with a loss in every reach cycles
constexpr double detectionRatio = 2;   // change over price from which a loss is detected
constexpr double visibleRatio = 4;     // change over price from which a loss counts
constexpr double detectedShare = 0.9;  // of the losses
constexpr double settledShare = 0.95;  // of what a loss changes
constexpr double margin = 1.25;        // losses near each other take longer to separate

/// Sum of what a loss changes, in squares over noise, up to each of the cycles after it.
std::vector<double> changeAfter(std::size_t cycle, const Prediction& with, const Prediction& without,
                                const Evidence& evidence, std::size_t t) {
  std::vector<double> change;
  for (std::size_t k = cycle + 1; k < cycle + LossResponse::reach; ++k) {
    double& sum = change.emplace_back(0);
    for (std::size_t s = 0; s < without.values.size(); ++s) {
      if (evidence.trials()[t].signals[s].joint < 0 || without.values[s].empty()) continue;
      const double w = evidence.weights(t, s)[k], d = with.values[s][k] - without.values[s][k];
      if (w > 0 && std::isfinite(d)) sum += w * d * d;
    }
  }
  std::partial_sum(change.begin(), change.end(), change.begin());
  return change;
}

/// Cycles until a sum has come to a size.
std::size_t cyclesTo(double size, const std::vector<double>& sums) {
  return static_cast<std::size_t>(std::ranges::lower_bound(sums, size) - sums.begin()) + 1;
}

std::size_t quantile(std::vector<std::size_t> values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

}  // namespace

LossResponse lossResponse(const Plant& plant, const Evidence& evidence, std::size_t t, double price) {
  const std::size_t cycles = evidence.trials()[t].cycles();
  const Prediction none = replay(plant, evidence.trials()[t], {});
  std::vector<std::size_t> detection, settling;
  for (std::size_t n = 0; n < samples; ++n) {
    const std::size_t first = n * LossResponse::reach / samples;
    std::vector<std::uint8_t> lost(cycles, 0);
    for (std::size_t k = first; k < cycles; k += LossResponse::reach) lost[k] = 1;
    ReplayOptions options;
    options.lostCycles = &lost;
    const Prediction some = replay(plant, evidence.trials()[t], options);
    for (std::size_t k = first; k + LossResponse::reach <= cycles; k += LossResponse::reach) {
      const std::vector<double> change = changeAfter(k, some, none, evidence, t);
      if (change.back() < visibleRatio * price) continue;
      detection.push_back(cyclesTo(detectionRatio * price, change));
      settling.push_back(cyclesTo(settledShare * change.back(), change));
    }
  }
  LossResponse response;
  if (detection.empty()) return response;
  response.detectionCycles =
      std::max(response.detectionCycles,
               static_cast<std::size_t>(margin * static_cast<double>(quantile(detection, detectedShare))));
  response.settlingCycles = std::max(response.settlingCycles, quantile(settling, 0.5));
  return response;
}

}  // namespace plumbline::gap
