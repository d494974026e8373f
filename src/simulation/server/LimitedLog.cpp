#include "simulation/server/LimitedLog.h"

#include <algorithm>

#include "simulation/server/Sockets.h"

namespace plumbline::simulation {

void LimitedLog::operator()(const std::string& line) {
  std::string text = line;
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  const auto keptBack = limit_.admit(kindOfMessage(text), steadySeconds());
  if (!keptBack) return;
  if (*keptBack > 0) text += " (" + std::to_string(*keptBack) + " more like it were not written)";
  log_(text);
}

void LimitedLog::reportOverdue() {
  for (const auto& [kind, keptBack] : limit_.takeOverdue(steadySeconds()))
    log_(std::to_string(keptBack) + " more lines were not written: " + (kind.empty() ? "various" : kind));
}

}  // namespace plumbline::simulation
