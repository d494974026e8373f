#pragma once
#include "walking/model/ModelParameters.h"
#include "walking/model/WalkModel.h"

namespace plumbline::walking {

/// The linear inverted pendulum (Kajita et al. 2001; equations 4.1 and 4.2 of the thesis). The centre of mass
/// keeps its height and accelerates away from the centre of pressure. Single support uses the parameters of
/// section 4.3.1.
class LinearInvertedPendulum : public WalkModel {
public:
  /// height of the centre of mass [m]; copOffset: centre of pressure from the centre of the supporting sole,
  /// forward and to the outside [m].
  explicit LinearInvertedPendulum(double height, const Vec2& copOffset = Vec2::Zero(),
                                  const ModelParameters& fit = {})
      : LinearInvertedPendulum(Vec2(height, height), copOffset, fit) {}
  /// A height for the motion along x and another for that along y [m].
  LinearInvertedPendulum(const Vec2& heights, const Vec2& copOffset, const ModelParameters& fit);

  WalkState move(const WalkState& state, const WalkAction& action, double time) const override;

  /// Where the foot presses on the ground when it carries alone, in the state's frame [m].
  Vec2 pivot(const WalkState& state) const;
  /// Where the foot has to press for the mass to be in balance over it: not 0 if the fitted mass is not where
  /// it is taken to be. Forward alone; to the side the steps see to it [m].
  Vec2 balance() const { return Vec2(fitted_.massOffset.x() / fitted_.footFactor.x(), 0); }

private:
  struct Coefficients {
    Vec2 rate;  ///< sqrt(g / height) along x and y [1/s]
    double timeFactor;
    Vec2 massOffset, velocityOffset, footFactor;
  };
  static WalkState move(const WalkState& state, const Vec2& cop, const WalkAction& action, double time,
                        const Coefficients& c);

  Vec2 plainRate_;  ///< without the ten parameters
  Vec2 copOffset_;
  Coefficients fitted_;
};

}  // namespace plumbline::walking
