#pragma once
#include <cmath>
#include <cstdint>

#include "field/TeamSize.h"

namespace plumbline {

/// Decides which player may speak, without communication. The server's clock, which all players know, is
/// divided into slots of two cycles, because SimSpark transmits one message of a team in two cycles. The
/// slots belong to the players in the order of their numbers.
struct SaySlot {
  static constexpr double seconds = 0.04;

  /// The slot of a time of the server's clock [s].
  static std::int64_t at(double time) { return static_cast<std::int64_t>(std::floor(time / seconds + 1e-4)); }
  /// The uniform number whose slot it is.
  static int speaker(std::int64_t slot) {
    return static_cast<int>((slot % teamSize + teamSize) % teamSize) + 1;
  }
};

}  // namespace plumbline
