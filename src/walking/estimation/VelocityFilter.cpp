#include "walking/estimation/VelocityFilter.h"

#include <algorithm>
#include <cmath>

namespace plumbline::walking {
namespace {

constexpr double spread = 0.1;  ///< of the particles about a velocity that is given or seen [m/s]

}  // namespace

VelocityFilter::VelocityFilter(const VelocityFilterParameters& parameters)
    : parameters_(parameters), random_(parameters_.seed) {
  const auto count = static_cast<std::size_t>(std::max(2, parameters_.particles));
  particles_.resize(count);
  drawn_.resize(count);
  before_.resize(count);
  weights_.resize(count);
  reset();
}

void VelocityFilter::reset(const Vec2& velocity) {
  random_ = Random(parameters_.seed);
  mean_ = velocity;
  for (Vec2& particle : particles_)
    particle = velocity + spread * Vec2(random_.gaussian(), random_.gaussian());
}

void VelocityFilter::predict(const WalkModel& model, const WalkState& before, const WalkAction& action,
                             double dt, const VelocityEvidence& evidence) {
  const Eigen::Rotation2Dd turned(action.duration > 0 ? -action.turn * dt / action.duration : 0);
  // The feet do not feel a push by another robot, so some particles, the strays, must find it. They are drawn
  // around the velocity that is seen, and as many others around the estimate before.
  const std::size_t strays = numStrays(evidence);
  WalkState state = before;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    before_[i] = turned * particles_[i];
    double noise = parameters_.modelNoise * dt;
    if (i < strays) {
      particles_[i] = *evidence.seen;
      noise = parameters_.slipNoise;
    } else if (evidence.change) {
      particles_[i] = before_[i] + *evidence.change;
      if (i >= 2 * strays) noise = parameters_.forceNoise;
    } else {
      state.velocity = particles_[i];
      particles_[i] = model.move(state, action, dt).velocity;
    }
    particles_[i] += noise * Vec2(random_.gaussian(), random_.gaussian());
  }
}

/// This number of particles takes the velocity that is seen, whatever was known before.
std::size_t VelocityFilter::numStrays(const VelocityEvidence& evidence) const {
  constexpr double share = 0.1;
  if (!evidence.change || !evidence.seen) return 0;
  return static_cast<std::size_t>(share * static_cast<double>(particles_.size()));
}

const Vec2& VelocityFilter::update(const WalkModel& model, const WalkState& before, const WalkAction& action,
                                   double dt, const VelocityEvidence& evidence) {
  predict(model, before, action, dt, evidence);
  const bool forces = evidence.change.has_value();
  const std::size_t strays = numStrays(evidence);
  const double noise = forces ? parameters_.slipNoise : parameters_.footNoise / dt;
  double total = 0;
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    weights_[i] = 1;
    if (evidence.seen && forces) {
      // Student's t with three degrees of freedom: a foot that slides is an outlier.
      const double miss = (particles_[i] - *evidence.seen).squaredNorm() / (3 * noise * noise);
      weights_[i] = 1 / ((1 + miss) * (1 + miss));
      // A foot that slides for a cycle is more common than a push; a lasting change is believed next time.
      if (i < strays) weights_[i] *= parameters_.pushOdds;
    } else if (evidence.seen) {
      const double miss = ((before_[i] + particles_[i]) / 2 - *evidence.seen).squaredNorm();
      weights_[i] = std::exp(-miss / (2 * noise * noise));
    }
    total += weights_[i];
    sum += weights_[i] * particles_[i];
  }
  // No particle explains what was seen: restart from it.
  if (!(total > 1e-12)) {
    for (Vec2& particle : particles_)
      particle = *evidence.seen + spread * Vec2(random_.gaussian(), random_.gaussian());
    return mean_ = *evidence.seen;
  }
  mean_ = sum / total;
  resample(total);
  return mean_;
}

void VelocityFilter::resample(double total) {
  const double step = total / static_cast<double>(particles_.size());
  double at = step * random_.uniform(), passed = weights_[0];
  std::size_t i = 0;
  for (Vec2& particle : drawn_) {
    while (passed < at && i + 1 < particles_.size()) passed += weights_[++i];
    particle = particles_[i];
    at += step;
  }
  std::swap(particles_, drawn_);
}

}  // namespace plumbline::walking
