#include "simulation/sensors/Hearing.h"

#include <algorithm>

namespace plumbline::simulation {

void Hearing::hear(const std::string& text, const std::string& team, double direction, bool mate) {
  Ear& ear = mate ? mates_ : opponents_;
  if (ear.capacityLeft < cost) return;
  ear.capacityLeft -= cost;
  ear.message = simspark::HeardMessage{team, 0, false, direction, text};
}

std::vector<simspark::HeardMessage> Hearing::collect(const std::string& ownTeam, double gameTime) {
  std::vector<simspark::HeardMessage> heard;
  if (self_) heard.push_back({ownTeam, gameTime, true, 0, *self_});
  self_.reset();
  for (Ear* ear : {&mates_, &opponents_}) {
    ear->capacityLeft = std::min(capacity, ear->capacityLeft + recovery);
    if (!ear->message) continue;
    ear->message->time = gameTime;
    heard.push_back(std::move(*ear->message));
    ear->message.reset();
  }
  return heard;
}

}  // namespace plumbline::simulation
