#include "web/GameMessage.h"

#include <nlohmann/json.hpp>

namespace plumbline::web {

using nlohmann::json;

std::string gameMessage(const GameStatus& status, const simspark::SceneState& scene,
                        const std::optional<simspark::SimulatorClock>& clock) {
  json message = {{"kind", "game"},
                  {"source", status.source},
                  {"problem", status.problem},
                  {"live", status.live},
                  {"connected", status.connected},
                  {"recording", status.recording},
                  {"half", scene.half},
                  {"mode", scene.playMode},
                  {"left", {{"name", scene.teamLeft}, {"score", scene.scoreLeft}}},
                  {"right", {{"name", scene.teamRight}, {"score", scene.scoreRight}}},
                  {"clock", nullptr}};
  if (clock) message["clock"] = {{"paused", clock->paused}, {"speed", clock->speed}};
  // Teams may send what is no UTF-8.
  return message.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace plumbline::web
