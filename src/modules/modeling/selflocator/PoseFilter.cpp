#include "modules/modeling/selflocator/PoseFilter.h"

#include <algorithm>
#include <cmath>

#include "math/Angle.h"

namespace plumbline {
namespace {

constexpr double maxMeanError = 25;  ///< per measurement; beyond this, all wrong particles are equally wrong
/// The mean likelihood of fitting images is rarely lower. With a lower reference, a filter that never fitted
/// would not notice it.
constexpr double leastReference = 0.3;
constexpr double uncertainFactor = 20;   ///< odometry's noise of a robot that falls or lies
constexpr double clusterDistance = 0.4;  ///< particles nearer than this to the best make the estimate [m]
constexpr double clusterTurn = 0.3;      ///< [rad]

/// Likelihood of an image per measurement, in (0, 1]: 0.6 where all errors are as large as expected.
double likelihood(const Fit& fit, std::size_t numLines) {
  if (fit.measurements == 0 && numLines == 0) return 1;
  const double mean = fit.error / std::max(1, fit.measurements);
  const double lines = (1.0 + fit.matchedLines) / (1.0 + static_cast<double>(numLines));
  return std::exp(-0.5 * std::min(mean, maxMeanError)) * lines;
}

}  // namespace

PoseFilter::PoseFilter(const FieldMap& map, const Parameters& parameters)
    : map_(map), parameters_(parameters), random_(parameters.seed), proposals_(map_) {
  const auto count = static_cast<std::size_t>(std::max(1, parameters.particles));
  particles_.reserve(count);
  resampled_.reserve(count);
}

void PoseFilter::setParameters(const Parameters& changed) {
  parameters_ = changed;
  const auto count = static_cast<std::size_t>(std::max(1, parameters_.particles));
  particles_.reserve(count);
  resampled_.reserve(count);
}

void PoseFilter::reset() {
  particles_.clear();
  estimate_ = Estimate();
}

void PoseFilter::predict(const Pose2& step, bool uncertain) {
  const double factor = uncertain ? uncertainFactor : 1;
  const double way = factor * (parameters_.stepNoise + parameters_.stepShare * step.position.norm());
  const double turn = factor * (parameters_.turnNoise + parameters_.turnShare * std::abs(step.heading));
  const PoseStep moved(step, Vec3(way, way, turn));
  for (Particle& particle : particles_) moved.apply(particle.belief);
  estimatePose();
}

void PoseFilter::update(const FieldView& view) {
  if (view.landmarks.empty() && view.lines.empty()) return;
  if (particles_.empty()) {
    start(view);
    return;
  }
  const PoseUpdate image(map_, view);
  double total = 0, mean = 0;
  for (Particle& particle : particles_) {
    const double l = likelihood(image.apply(particle.belief), view.lines.size());
    mean += particle.weight * l;
    particle.weight *= l;
    total += particle.weight;
  }
  for (Particle& particle : particles_) particle.weight /= total;
  slow_ += parameters_.slowRate * (mean - slow_);
  fast_ += parameters_.fastRate * (mean - fast_);

  double squares = 0;
  for (const Particle& particle : particles_) squares += particle.weight * particle.weight;
  if (2 / squares < static_cast<double>(particles_.size())) resample();
  const double share = std::max(0.0, 1 - fast_ / std::max(slow_, leastReference));
  if (share > 0.2) resetFromImage(view, share);
  estimatePose();
}

void PoseFilter::start(const FieldView& view) {
  const std::vector<PoseBelief>& found = proposals_.find(view);
  if (found.empty()) return;
  const auto count = static_cast<std::size_t>(std::max(1, parameters_.particles));
  for (std::size_t i = 0; i < count; ++i)
    particles_.push_back({found[i % found.size()], 1.0 / static_cast<double>(count)});
  slow_ = fast_ = leastReference;
  estimatePose();
}

/// Systematic resampling; copies are moved a little apart, by half a deviation of their belief.
void PoseFilter::resample() {
  const auto count = static_cast<double>(particles_.size());
  resampled_.clear();
  double position = random_.uniform() / count, sum = 0;
  for (const Particle& particle : particles_) {
    sum += particle.weight;
    for (bool copy = false; position < sum && resampled_.size() < particles_.size(); copy = true) {
      resampled_.push_back({particle.belief, 1 / count});
      if (copy) {
        const auto jitter = [&](int i) {
          return 0.5 * std::sqrt(particle.belief.covariance(i, i)) * random_.gaussian();
        };
        Pose2& pose = resampled_.back().belief.pose;
        const double x = jitter(0), y = jitter(1), turn = jitter(2);
        pose = pose * Pose2(x, y, turn);
      }
      position += 1 / count;
    }
  }
  while (resampled_.size() < particles_.size()) resampled_.push_back({particles_.back().belief, 1 / count});
  particles_.swap(resampled_);
}

void PoseFilter::resetFromImage(const FieldView& view, double share) {
  const std::vector<PoseBelief>& found = proposals_.find(view);
  if (found.empty()) return;
  const auto count =
      std::max<std::size_t>(1, static_cast<std::size_t>(share * static_cast<double>(particles_.size())));
  // The worst make room.
  std::stable_sort(particles_.begin(), particles_.end(),
                   [](const Particle& a, const Particle& b) { return a.weight > b.weight; });
  double total = 0;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const std::size_t fromEnd = particles_.size() - 1 - i;
    if (fromEnd < count)
      particles_[i] = {found[fromEnd % found.size()], 1.0 / static_cast<double>(particles_.size())};
    total += particles_[i].weight;
  }
  for (Particle& particle : particles_) particle.weight /= total;
  resets_ += static_cast<int>(count);
}

void PoseFilter::estimatePose() {
  if (particles_.empty()) {
    estimate_ = Estimate();
    return;
  }
  const Particle& best =
      *std::max_element(particles_.begin(), particles_.end(),
                        [](const Particle& a, const Particle& b) { return a.weight < b.weight; });
  const Pose2& centre = best.belief.pose;
  Vec2 shift = Vec2::Zero();
  double turn = 0, total = 0, position = 0, heading = 0;
  for (const Particle& particle : particles_) {
    const Vec2 d = particle.belief.pose.position - centre.position;
    const double t = normalizeAngle(particle.belief.pose.heading - centre.heading);
    if (d.norm() > clusterDistance || std::abs(t) > clusterTurn) continue;
    const Mat3& covariance = particle.belief.covariance;
    shift += particle.weight * d;
    turn += particle.weight * t;
    position += particle.weight * (d.squaredNorm() + covariance(0, 0) + covariance(1, 1));
    heading += particle.weight * (t * t + covariance(2, 2));
    total += particle.weight;
  }
  shift /= total;
  turn /= total;
  estimate_.pose = Pose2(Vec2(centre.position + shift), normalizeAngle(centre.heading + turn));
  estimate_.positionDeviation = std::sqrt(std::max(0.0, position / total - shift.squaredNorm()));
  estimate_.headingDeviation = std::sqrt(std::max(0.0, heading / total - turn * turn));
  estimate_.valid = total > 0.5 && estimate_.positionDeviation < parameters_.validDeviation &&
                    estimate_.headingDeviation < parameters_.validHeadingDeviation;
}

}  // namespace plumbline
