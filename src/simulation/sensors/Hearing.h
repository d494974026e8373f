#pragma once
#include <optional>
#include <string>
#include <vector>

#include "simspark/ServerMessage.h"

namespace plumbline::simulation {

/// The ears of one player: its own words always, and from each team one message in two cycles, the first that
/// comes.
class Hearing {
public:
  void hearSelf(const std::string& text) { self_ = text; }
  /// direction [rad]: where the speaker is, in the field frame of the own team.
  void hear(const std::string& text, const std::string& team, double direction, bool mate);
  /// What reached the ears since the last call; to be called once a cycle.
  std::vector<simspark::HeardMessage> collect(const std::string& ownTeam, double gameTime);

private:
  static constexpr int capacity = 2, cost = 2, recovery = 1;
  struct Ear {
    int capacityLeft = capacity;
    std::optional<simspark::HeardMessage> message;
  };
  std::optional<std::string> self_;
  Ear mates_, opponents_;
};

}  // namespace plumbline::simulation
