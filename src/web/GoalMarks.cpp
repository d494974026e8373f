#include "web/GoalMarks.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "framework/Json.h"

namespace plumbline::web {

using nlohmann::json;

namespace {

constexpr std::size_t maxGoals = 1000;

double scoreOf(const json& game, const char* side) {
  if (!game.is_object() || !game.contains(side) || !game[side].is_object()) return 0;
  const json& team = game[side];
  return team.contains("score") && team["score"].is_number() ? team["score"].get<double>() : 0;
}

}  // namespace

json gameOf(const MatchRecord& record, const std::string& file) {
  try {
    return parseJson(record.message);
  } catch (const JsonError& error) {
    char time[32];
    std::snprintf(time, sizeof time, "%.2f", record.time);
    throw std::runtime_error(file + ": the game's state at " + time + " s " +
                             (error.line == 0 ? error.what() : "is broken JSON"));
  }
}

void GoalMarks::add(const std::vector<MatchRecord>& records, const std::string& file) {
  for (const MatchRecord& record : records) {
    if (record.channel != Channel::game || found_.size() >= maxGoals) continue;
    const json game = gameOf(record, file);
    const Score now{scoreOf(game, "left"), scoreOf(game, "right")};
    if (last_ && now.left > last_->left) found_.push_back({record.time, true});
    if (last_ && now.right > last_->right) found_.push_back({record.time, false});
    last_ = now;
  }
}

}  // namespace plumbline::web
