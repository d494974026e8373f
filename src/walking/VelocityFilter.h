#pragma once
#include <cstdint>
#include <vector>

#include "math/Random.h"
#include "walking/WalkModel.h"

namespace plumbline::walking {

/// How far the filter trusts what it is told. The noise of the model is high on purpose: a difference to the
/// model is what the estimate is for (section 4.2.5).
struct VelocityFilterParameters {
  int particles = 100;
  double modelNoise = 0.1;   ///< of the velocity in one cycle [m/s]
  double footNoise = 0.025;  ///< of the velocity seen in the supporting foot's movement [m/s]
  std::uint64_t seed = 1;
};

/// Particle filter (Thrun et al., "Probabilistic Robotics", table 4.3) for the velocity of the centre of mass
/// over the ground, from the model and the movement of the supporting foot in the frame of the centre of
/// mass. Same calls, same answers; allocates nothing after the construction.
class VelocityFilter {
public:
  explicit VelocityFilter(const VelocityFilterParameters& parameters = {});

  /// All particles near this velocity [m/s].
  void reset(const Vec2& velocity = Vec2::Zero());
  /// A cycle of dt [s]: `before` as it was observed at its start (the velocity in it is not used), the action
  /// that went on, and the mean velocity seen during the cycle, in the frame at its end [m/s]. Returns the
  /// velocity at the end, in that frame.
  const Vec2& update(const WalkModel& model, const WalkState& before, const WalkAction& action, double dt,
                     const Vec2& seen);
  const Vec2& velocity() const { return mean; }

private:
  void resample(double total);

  VelocityFilterParameters parameters;
  Random random;
  std::vector<Vec2> particles, drawn;
  std::vector<double> weights;
  Vec2 mean = Vec2::Zero();
};

}  // namespace plumbline::walking
