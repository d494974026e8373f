#pragma once
#include "walking/ModelParameters.h"
#include "walking/WalkModel.h"

namespace plumbline::walking {

/// The linear inverted pendulum (Kajita et al. 2001; equations 4.1 and 4.2 of the thesis): the centre of mass
/// keeps its height and is pushed away from the centre of pressure; with the parameters of section 4.3.1.
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

private:
  Vec2 k;  ///< sqrt(g / height) along x and y [1/s]
  Vec2 copOffset;
  Vec2 massOffset, velocityOffset, footFactor;
  double timeFactor;
};

}  // namespace plumbline::walking
