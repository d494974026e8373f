#pragma once
#include <string>

namespace plumbline {

/// Names of the motions that other modules ask for. A motion needs no entry here: its name is what its
/// MotionOutput says.
struct Motion {
  static constexpr const char* stand = "stand";
  static constexpr const char* walk = "walk";
  static constexpr const char* specialAction = "specialAction";  ///< keyframes of motions/
  static constexpr const char* kick = "kick";
  static constexpr const char* dead = "dead";
};

}  // namespace plumbline
