#pragma once
#include <optional>
#include <string>

#include "simspark/SceneState.h"
#include "simspark/TrainerCommand.h"

namespace plumbline::web {

/// What a page shows beside the field, as JSON:
/// {"kind":"game","source":,"problem":,"live":,"connected":,"half":,"mode":,
/// "left":{"name":,"score":},"right":...,"clock":{"paused":,"speed":} or null,"recording":}. clock is null on
/// a server that cannot pause.
struct GameStatus {
  std::string source;      ///< whom the page looks at: "127.0.0.1:3200", a file
  std::string problem{};   ///< why nothing comes, one line; empty: it comes
  bool live = true;        ///< takes trainer commands, while it is there
  bool connected = false;  ///< it is there
  std::string recording{};
};
std::string gameMessage(const GameStatus& status, const simspark::SceneState& scene,
                        const std::optional<simspark::SimulatorClock>& clock);

}  // namespace plumbline::web
