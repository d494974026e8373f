#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "math/Random.h"
#include "walking/model/WalkModel.h"

namespace plumbline::walking {

/// Noise parameters of the filter. The noise of the model is high on purpose, because the estimate shall show
/// differences from the model (section 4.2.5).
struct VelocityFilterParameters {
  int particles = 100;
  double modelNoise = 5;      ///< of the mass's acceleration by the model [m/s^2]
  double footNoise = 0.0005;  ///< of the supporting foot's movement in one cycle [m]
  double forceNoise = 0.01;   ///< of the change of velocity in one cycle, by the ground's forces [m/s]
  double slipNoise = 0.03;    ///< of the velocity seen in the movement of what touches the ground [m/s]
  double pushOdds = 0.001;    ///< odds that a motion without a measured force is a push, not a sliding foot
  std::uint64_t seed = 1;
};

/// Evidence of the velocity from one cycle, in the frame at its end [m/s].
struct VelocityEvidence {
  std::optional<Vec2> change;  ///< in the cycle, by the ground's forces; none: the model knows better
  std::optional<Vec2> seen;    ///< in what touches the ground; none: nothing does
};

/// Particle filter (Thrun et al., "Probabilistic Robotics", table 4.3) for the velocity of the centre of mass
/// over the ground. It uses the model, or the forces if they are measured, and the movement of the support
/// foot in the frame of the centre of mass. Same calls, same answers; allocates nothing after the
/// construction.
class VelocityFilter {
public:
  explicit VelocityFilter(const VelocityFilterParameters& parameters = {});

  /// All particles near this velocity [m/s].
  void reset(const Vec2& velocity = Vec2::Zero());
  /// A cycle of dt [s]: `before` as it was observed at its start (the velocity in it is not used), the action
  /// that went on, and what was measured. Returns the velocity at the end, in the frame at the end. Without
  /// forces the observation is the mean over the cycle. With forces it is the velocity at its end, as in the
  /// league's physics with one step per cycle; it may sometimes be wrong (a sliding foot).
  const Vec2& update(const WalkModel& model, const WalkState& before, const WalkAction& action, double dt,
                     const VelocityEvidence& evidence);
  const Vec2& velocity() const { return mean_; }

private:
  void predict(const WalkModel& model, const WalkState& before, const WalkAction& action, double dt,
               const VelocityEvidence& evidence);
  std::size_t numStrays(const VelocityEvidence& evidence) const;
  void resample(double total);

  VelocityFilterParameters parameters_;
  Random random_;
  std::vector<Vec2> particles_, drawn_;
  std::vector<Vec2> before_;  ///< the particles at the cycle's beginning, in the frame at its end
  std::vector<double> weights_;
  Vec2 mean_ = Vec2::Zero();
};

}  // namespace plumbline::walking
