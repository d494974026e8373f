#pragma once
#include "walking/model/WalkState.h"

namespace plumbline::walking {

/// How the robot moves: the only knowledge the walk has of it (section 4.2.1). Planning uses it as a black
/// box.
class WalkModel {
public:
  virtual ~WalkModel() = default;

  /// The state after time seconds of the action, 0 <= time <= action.duration. The frame moves and turns with
  /// the centre of mass, feet on the ground stay where they are.
  virtual WalkState move(const WalkState& state, const WalkAction& action, double time) const = 0;

  /// The state at the end of the action; after a step the swing foot stands at its target and carries.
  WalkState predict(const WalkState& state, const WalkAction& action) const {
    WalkState end = move(state, action, action.duration);
    if (state.support != Support::both) {
      const Side swing = other(state.supportSide());
      end.foot[index(swing)] = action.stepTarget;
      end.support = supportOf(swing);
    }
    return end;
  }
};

}  // namespace plumbline::walking
