#pragma once
#include <algorithm>
#include <vector>

#include "framework/Representation.h"
#include "math/Pose2.h"

namespace plumbline {

/// Where a player of the own team was by its last words, and where the team's plan sends it; team's frame.
struct PlacedPlayer : public Streamable {
  int number = 0;
  double heading = 0;   ///< of the player [rad]
  bool placed = false;  ///< it has a place: not the goalie, nor who goes to the ball
  Pose2 place;          ///< [m, rad]
  void stream(InStream* in, OutStream* out) override {
    STREAM(number);
    STREAM(heading);
    STREAM(placed);
    STREAM("placePosition", place.position);
    STREAM("placeHeading", place.heading);
  }
};

/// The players that have spoken, by number.
REPRESENTATION(TeamPlaces)
class TeamPlaces : public TeamPlacesBase {
public:
  std::vector<PlacedPlayer> players;
  /// Null: it is not known.
  const PlacedPlayer* of(int number) const {
    const auto it = std::ranges::find(players, number, &PlacedPlayer::number);
    return it != players.end() ? &*it : nullptr;
  }
  void stream(InStream* in, OutStream* out) override { STREAM(players); }
};

}  // namespace plumbline
