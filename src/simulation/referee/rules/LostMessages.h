#pragma once
#include <cstdint>

#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// Words that do not reach others, as on a server under load. Off in the league. The referee does nothing
/// here: who speaks asks isLost().
class LostMessages : public Rule {
public:
  struct Parameters {
    PARAMETERS(Parameters)
    PARAMETER(double, share, 0, "", Range(0, 1),
              "not in the league: of the words that a player says to another one; by lot, from the seed")
  };
  void play(Match&) override {}

  /// Whether the words of a player do not reach another one in a cycle; both by their ids. It depends on
  /// nothing but these numbers, so a loss does not change others.
  static bool isLost(const Parameters& rules, std::uint64_t seed, std::uint64_t cycle, int speaker,
                     int listener);
};

}  // namespace plumbline::simulation
