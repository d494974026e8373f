#include "gap/record/Waves.h"

#include <algorithm>
#include <cmath>

#include "math/Random.h"

namespace plumbline::gap {
namespace {

constexpr double turn = 2 * M_PI;

/// 0 at both ends of the duration, 1 between, swelling for `ramp` seconds.
double window(double t, double duration, double ramp) {
  const double end = std::min(t, duration - t);
  return smoothStep(end / std::min(ramp, duration / 2));
}

}  // namespace

double smoothStep(double x) {
  if (!(x > 0)) return 0;
  if (x >= 1) return 1;
  return x * x * x * (10 + x * (6 * x - 15));
}

Wave::Wave(const Segment& segment, int joint, double maxSpeed, double maxAcceleration)
    : segment_(segment), seed_(segment.seed * 1'000'003 + static_cast<std::uint64_t>(joint)) {
  if (segment_.kind == Segment::Kind::multisine) planMultisine();
  if (segment_.kind == Segment::Kind::fast) planFast(maxSpeed, maxAcceleration);
}

double Wave::operator()(double t) const {
  const double T = segment_.duration;
  switch (segment_.kind) {
    case Segment::Kind::triangle: {
      constexpr double rounding = 0.97;  // 1: sharp corners
      return std::asin(rounding * std::sin(turn * segment_.cycles * t / T)) / std::asin(rounding);
    }
    case Segment::Kind::chirp:
      return window(t, T, 0.15) *
             std::sin(turn * t * (segment_.fromHz + 0.5 * (segment_.toHz - segment_.fromHz) * t / T));
    case Segment::Kind::steps: {
      constexpr double levels[] = {1, -1, 0.5, -0.5, 0};
      return levels[std::min<std::size_t>(4, static_cast<std::size_t>(5 * t / T))];
    }
    case Segment::Kind::sine:
      return window(t, T, T / 4) * std::sin(turn * (segment_.fromHz * t + segment_.phase));
    case Segment::Kind::bumps: {
      const double up = std::max(0.0, std::sin(turn * (segment_.fromHz * t + segment_.phase)));
      return window(t, T, T / 4) * up * up;
    }
    case Segment::Kind::multisine: {
      double sum = 0;
      for (const Tone& tone : tones_) sum += std::sin(turn * tone.hz * t + tone.phase);
      return window(t, T, 0.5) * scale_ * sum;
    }
    case Segment::Kind::fast:
      return fast(t);
    case Segment::Kind::move:
      break;
  }
  return 0;
}

void Wave::planMultisine() {
  Random random(seed_);
  const double ratio = segment_.toHz / segment_.fromHz;
  for (int k = 0; k < segment_.tones; ++k) {
    const double place = (k + random.uniform()) / segment_.tones;
    tones_.push_back({segment_.fromHz * std::pow(ratio, place), turn * random.uniform()});
  }
  double most = 1e-9;
  constexpr double sample = 0.005;  // [s]
  for (int i = 0; i * sample < segment_.duration; ++i) {
    double sum = 0;
    for (const Tone& tone : tones_) sum += std::sin(turn * tone.hz * i * sample + tone.phase);
    most = std::max(most, std::abs(sum));
  }
  scale_ = 1 / most;
}

void Wave::planFast(double maxSpeed, double maxAcceleration) {
  Random random(seed_);
  double t = 0.05 * random.uniform(), from = 0;
  double side = random.uniform() < 0.5 ? -1 : 1;
  const double speed = std::max(1e-6, segment_.speed * maxSpeed);
  constexpr double peakSpeed = 1.875, peakAcceleration = 5.7735;  // of smoothStep
  const auto timeFor = [&](double way) {
    return std::max(peakSpeed * std::abs(way) / speed,
                    std::sqrt(peakAcceleration * std::abs(way) / maxAcceleration));
  };
  for (;;) {
    const double to = side * random.uniform(0.6, 1.0);
    side = -side;
    const double arrival = t + timeFor(to - from), end = arrival + random.uniform(0.35, 0.45);
    if (end + timeFor(to) > segment_.duration) break;
    legs_.push_back({t, arrival, end, from, to, -0.1 * (to > 0 ? 1 : -1)});
    t = end;
    from = to;
  }
  legs_.push_back({t, t + timeFor(from), segment_.duration, from, 0, 0});
}

double Wave::fast(double t) const {
  for (const Leg& leg : legs_) {
    if (t >= leg.end) continue;
    if (t < leg.start) return leg.from;
    if (t < leg.arrival)
      return leg.from + (leg.to - leg.from) * smoothStep((t - leg.start) / (leg.arrival - leg.start));
    const double since = t - leg.arrival;
    return leg.to + (since > 0.1 && since < 0.2 ? leg.step : 0);
  }
  return 0;
}

}  // namespace plumbline::gap
