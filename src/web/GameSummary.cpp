#include "web/GameSummary.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "framework/ConfigFolder.h"
#include "framework/ReadFile.h"
#include "framework/StopSignal.h"
#include "web/Frame.h"
#include "web/GoalMarks.h"
#include "web/MatchFile.h"

namespace plumbline::web {
namespace {

using nlohmann::json;

constexpr double step = 0.1, rest = 0.5;    // between two places [s]; of the recording while the clock stands
constexpr std::size_t mostPlaces = 200000;  // five and a half hours
constexpr std::size_t maxPage = std::size_t{64} << 20;  // [bytes]
constexpr std::size_t mostRobots = 64;
constexpr double leastCosineNotLying = 0.5;  // of the torso's tilt

template <class T>
T take(std::string_view bytes, std::size_t place) {
  T value;
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

struct Place {
  int x = 0, y = 0;  ///< [cm]
  bool up = true;
};
struct Moment {
  double clock = 0;
  std::array<int, 3> ball{};  ///< [cm]
  std::map<std::pair<int, int>, Place> robots;
};

int centimetres(float metres) {
  return std::isfinite(metres)
             ? static_cast<int>(std::lround(std::fmin(1e5F, std::fmax(-1e5F, 100 * metres))))
             : 0;
}

/// The z component of the z axis of an orientation as a frame has it; 1 without bodies.
double upOf(std::string_view bytes, std::size_t at, int parts) {
  if (parts == 0) return 1;
  const std::size_t orientation = at + frameRobotBytes + 6;
  const double x = take<std::int16_t>(bytes, orientation) / 32767.0;
  const double y = take<std::int16_t>(bytes, orientation + 2) / 32767.0;
  return 1 - 2 * (x * x + y * y);
}

/// False for what is no frame.
bool readFrame(std::string_view bytes, Moment& moment) {
  if (bytes.size() < frameHeaderBytes || bytes[0] != 1) return false;
  const auto count = static_cast<std::size_t>(static_cast<std::uint8_t>(bytes[1]));
  moment.clock = take<double>(bytes, 4);
  if (!std::isfinite(moment.clock)) return false;
  for (std::size_t i = 0; i < 3; ++i) moment.ball[i] = centimetres(take<float>(bytes, 12 + 4 * i));
  std::size_t at = frameHeaderBytes;
  for (std::size_t i = 0; i < count; ++i) {
    if (bytes.size() < at + frameRobotBytes) return false;
    const int side = static_cast<std::uint8_t>(bytes[at]), unum = static_cast<std::uint8_t>(bytes[at + 1]);
    const int parts = static_cast<std::uint8_t>(bytes[at + 3]);
    const std::size_t size = frameRobotBytes + framePartBytes * static_cast<std::size_t>(parts);
    if (bytes.size() < at + size) return false;
    if (side == 1 || side == 2)
      moment.robots[{side, unum}] = {centimetres(take<float>(bytes, at + 4)),
                                     centimetres(take<float>(bytes, at + 8)),
                                     upOf(bytes, at, parts) > leastCosineNotLying};
    at += size;
  }
  return true;
}

/// What of a game's state a summary tells; the same again is left out.
json stateOf(const json& game) {
  const auto text = [&](const json& from, const char* key) {
    return from.is_object() && from.contains(key) && from[key].is_string() ? from[key].get<std::string>()
                                                                           : "";
  };
  const auto number = [&](const json& from, const char* key) {
    return from.is_object() && from.contains(key) && from[key].is_number() ? from[key].get<double>() : 0.0;
  };
  const json none;
  const auto team = [&](const char* key) -> const json& {
    return game.is_object() && game.contains(key) ? game[key] : none;
  };
  return {{"mode", text(game, "mode")},
          {"half", number(game, "half")},
          {"left", number(team("left"), "score")},
          {"right", number(team("right"), "score")},
          {"names", {text(team("left"), "name"), text(team("right"), "name")}}};
}

json tracksOf(const std::vector<Moment>& moments) {
  std::map<std::pair<int, int>, json> robots;
  for (const Moment& moment : moments)
    for (const auto& [who, place] : moment.robots)
      if (robots.size() < mostRobots || robots.contains(who)) robots[who] = json::array();
  for (const Moment& moment : moments)
    for (auto& [who, track] : robots) {
      const auto found = moment.robots.find(who);
      if (found == moment.robots.end()) {
        track.push_back(nullptr);
        track.push_back(nullptr);
        track.push_back(nullptr);
      } else {
        track.push_back(found->second.x);
        track.push_back(found->second.y);
        track.push_back(found->second.up ? 1 : 0);
      }
    }
  json result = json::array();
  for (auto& [who, track] : robots)
    result.push_back({{"side", who.first == 1 ? "left" : "right"}, {"unum", who.second}, {"track", track}});
  return result;
}

}  // namespace

std::string gameTracks(const std::string& recording) {
  MatchReader reader(recording);
  json field, states = json::array(), times = json::array(), clock = json::array(), ball = json::array();
  json before;
  std::vector<Moment> moments;
  double next = 0;
  for (std::size_t chunk = 0; chunk < reader.numChunks(); ++chunk) {
    StopSignal::throwIfCaught();
    for (const MatchRecord& record : reader.read(chunk)) {
      if (record.channel == Channel::geometry && field.is_null()) {
        const json geometry = gameOf(record, recording);
        if (geometry.is_object() && geometry.contains("field")) field = geometry["field"];
      } else if (record.channel == Channel::game) {
        json state = stateOf(gameOf(record, recording));
        if (state == before) continue;
        before = state;
        state["t"] = std::round(100 * record.time) / 100;
        state["clock"] = moments.empty() ? 0.0 : moments.back().clock;
        states.push_back(std::move(state));
      } else if (record.channel == Channel::frame && moments.size() < mostPlaces) {
        // By the game's clock: a game may run faster or slower than the recording.
        Moment moment;
        if (!readFrame(record.message, moment)) continue;
        const double passed = moments.empty() ? step : std::fabs(moment.clock - moments.back().clock);
        if (passed < step - 1e-3 && record.time < next) continue;
        next = record.time + rest;
        times.push_back(std::round(100 * record.time) / 100);
        clock.push_back(std::round(100 * moment.clock) / 100);
        for (const int value : moment.ball) ball.push_back(value);
        moments.push_back(std::move(moment));
      }
    }
  }
  if (moments.empty() || field.is_null()) throw std::runtime_error(recording + ": no game is in it");
  return json{{"recording", std::filesystem::path(recording).filename().string()},
              {"field", std::move(field)},
              {"states", std::move(states)},
              {"times", std::move(times)},
              {"clock", std::move(clock)},
              {"ball", std::move(ball)},
              {"robots", tracksOf(moments)}}
      .dump(-1, ' ', true, json::error_handler_t::replace);
}

std::string summaryPage(const std::string& builtPage, const std::string& tracks, const std::string& replay,
                        const std::string& decisions) {
  constexpr std::string_view mark = "/*GAME*/";
  const std::size_t at = builtPage.find(mark);
  if (at == std::string::npos)
    throw std::runtime_error("build/report/summary.html is broken: run `make web` again");
  // Within a script, < could begin the script's end.
  std::string text;
  for (const char c : "{\"replay\":" + json(replay).dump(-1, ' ', true) + ",\"decisions\":" + decisions +
                          ",\"game\":" + tracks + '}')
    c == '<' ? text += "\\u003c" : text += c;
  return builtPage.substr(0, at) + text + builtPage.substr(at + mark.size());
}

std::string builtSummaryPage() {
  const std::string programs = programFolder();
  for (const char* place : {"/../build/report/summary.html", "/../../report/summary.html"}) {
    if (std::filesystem::exists(programs + place)) return readFile(programs + place, maxPage);
  }
  throw std::runtime_error("the page of a summary is not built: run `make web` once");
}

}  // namespace plumbline::web
