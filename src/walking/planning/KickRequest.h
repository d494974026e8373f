#pragma once
#include <optional>

#include "walking/model/WalkState.h"

namespace plumbline::walking {

/// Progress of a kick in a step (section 4.4.1), from the request to its end.
struct KickRequest {
  std::optional<Side> foot;  ///< to kick with
  bool prepared = false;     ///< this step leads to it or is it
  bool now = false;
  bool done = false;

  /// A step begins in which this foot carries.
  void beginStep(Side support) {
    if (now) *this = {.foot = {}, .prepared = false, .now = false, .done = true};
    // The step before the kick already swings as far as the long step needs.
    if (foot && prepared && support == other(*foot)) now = true;
    if (foot && support == *foot) prepared = true;
  }
};

}  // namespace plumbline::walking
