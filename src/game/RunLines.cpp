#include "game/RunLines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline::game {

namespace {

/// An agent in step has written what it said so long ago: its answer to that cycle has come since [s].
constexpr double settled = 0.1;

std::string wordsAt(double time, const std::vector<StatusWords>& said) {
  const auto after =
      std::find_if(said.begin(), said.end(), [&](const StatusWords& s) { return s.time > time; });
  return after == said.begin() ? std::string() : std::prev(after)->words;
}

std::string complete(const RunLines::Line& line, double until, const std::vector<StatusWords>& said) {
  std::string words = wordsAt(std::min(line.time, until), said);
  if (line.goal)
    words = "GOAL";
  else if (line.fallen && words.empty())
    words = "fallen";
  std::string text = line.scene + ' ' + words;
  text.erase(text.find_last_not_of(' ') + 1);
  return text + '\n';
}

}  // namespace

std::string RunLines::due(double now, const std::vector<StatusWords>& said) {
  std::string text;
  const auto ready = [&](const Line& line) { return line.time + settled < now; };
  const auto end = std::find_if_not(waiting_.begin(), waiting_.end(), ready);
  for (auto line = waiting_.begin(); line != end; ++line) text += complete(*line, line->time, said);
  waiting_.erase(waiting_.begin(), end);
  return text;
}

std::string RunLines::rest(double end, const std::vector<StatusWords>& said) {
  std::string text;
  for (const Line& line : waiting_) text += complete(line, end - settled, said);
  waiting_.clear();
  return text;
}

}  // namespace plumbline::game
