#pragma once
#include <array>

#include "walking/model/WalkState.h"
#include "walking/parameters/WalkParameters.h"

namespace plumbline::walking {

/// Difference between the observed and the planned walk state, without the usual difference in this part of a
/// step. The model has the same error in every step (table 4.3), as large as a hard push; only the rest is a
/// disturbance (section 4.2.5).
class Disturbance {
public:
  void reset() { *this = {}; }
  /// A cycle of dt [s]; observed: moved on to the same moment as planned; phase: of the step, 0 .. 1; height:
  /// of the pendulum [m].
  void update(const WalkState& planned, const WalkState& observed, double phase, double height,
              const WalkParameters& p, double dt);

  /// A push was known by other means: all of the walk is recovery from now on, and for recovery.fadeTime less
  /// and less.
  void begin() { share_ = 1; }

  /// Position error of the support feet, in the frame of the centre of mass [m].
  const Vec2& foot() const { return now_.foot; }
  /// Velocity error of the centre of mass [m/s].
  const Vec2& velocity() const { return now_.velocity; }
  /// Error of the capture point (Pratt et al. 2006) over the ground [m].
  const Vec2& capturePoint() const { return capture_; }
  /// How much of the walk is recovery from a push, 0 .. 1.
  double share() const { return share_; }

private:
  struct Difference {
    Vec2 foot = Vec2::Zero(), velocity = Vec2::Zero();
  };
  static constexpr std::size_t parts = 8;                 ///< of a step
  std::array<std::array<Difference, parts>, 3> usual_{};  ///< of left, right and double support
  Difference now_;
  Vec2 capture_ = Vec2::Zero();
  double share_ = 0;
};

}  // namespace plumbline::walking
