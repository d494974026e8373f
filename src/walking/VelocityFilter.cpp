#include "walking/VelocityFilter.h"

#include <algorithm>
#include <cmath>

namespace plumbline::walking {

VelocityFilter::VelocityFilter(const VelocityFilterParameters& parameters_)
    : parameters(parameters_), random(parameters.seed) {
  const auto count = static_cast<std::size_t>(std::max(2, parameters.particles));
  particles.resize(count);
  drawn.resize(count);
  weights.resize(count);
  reset();
}

void VelocityFilter::reset(const Vec2& velocity) {
  random = Random(parameters.seed);
  mean = velocity;
  for (Vec2& particle : particles)
    particle = velocity + parameters.modelNoise * Vec2(random.gaussian(), random.gaussian());
}

const Vec2& VelocityFilter::update(const WalkModel& model, const WalkState& before, const WalkAction& action,
                                   double dt, const Vec2& seen) {
  const Eigen::Rotation2Dd turned(action.duration > 0 ? -action.turn * dt / action.duration : 0);
  const double precision = 1 / (2 * parameters.footNoise * parameters.footNoise);
  WalkState state = before;
  double total = 0;
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    state.velocity = particles[i];
    const Vec2 start = turned * particles[i];
    particles[i] = model.move(state, action, dt).velocity +
                   parameters.modelNoise * Vec2(random.gaussian(), random.gaussian());
    const double miss = ((start + particles[i]) / 2 - seen).squaredNorm();
    weights[i] = std::exp(-miss * precision);
    total += weights[i];
    sum += weights[i] * particles[i];
  }
  // No particle explains what was seen: begin anew from it.
  if (!(total > 1e-12)) {
    for (Vec2& particle : particles)
      particle = seen + parameters.modelNoise * Vec2(random.gaussian(), random.gaussian());
    return mean = seen;
  }
  mean = sum / total;
  resample(total);
  return mean;
}

void VelocityFilter::resample(double total) {
  const double step = total / static_cast<double>(particles.size());
  double at = step * random.uniform(), passed = weights[0];
  std::size_t i = 0;
  for (Vec2& particle : drawn) {
    while (passed < at && i + 1 < particles.size()) passed += weights[++i];
    particle = particles[i];
    at += step;
  }
  std::swap(particles, drawn);
}

}  // namespace plumbline::walking
