#pragma once
#include "walking/WalkModel.h"

namespace plumbline::walking {

/// The linear inverted pendulum (Kajita et al. 2001; equations 4.1 and 4.2 of the thesis): the centre of mass
/// keeps its height and is pushed away from the centre of pressure.
class LinearInvertedPendulum : public WalkModel {
public:
  /// height of the centre of mass [m]; copOffset: centre of pressure from the centre of the supporting sole,
  /// forward and to the outside [m].
  explicit LinearInvertedPendulum(double height, const Vec2& copOffset = Vec2::Zero());

  WalkState move(const WalkState& state, const WalkAction& action, double time) const override;

  /// Where the foot presses on the ground when it carries alone, in the state's frame [m].
  Vec2 pivot(const WalkState& state) const;
  /// sqrt(g / height) [1/s].
  double rate() const { return k; }

private:
  double k;
  Vec2 copOffset;
};

}  // namespace plumbline::walking
