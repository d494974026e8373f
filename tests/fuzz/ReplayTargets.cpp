// Recorded matches as a page plays them.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "fuzz/Readers.h"
#include "web/GoalMarks.h"
#include "web/MatchFile.h"
#include "web/ReplayFeed.h"

namespace plumbline::fuzz {
namespace {

using namespace web;

/// What a record says of the game: lines of one chunk.
void replayGame(std::string_view bytes) {
  std::vector<MatchRecord> records;
  for (std::size_t begin = 0; begin < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    records.push_back({0.1 * static_cast<double>(records.size()), Channel::game,
                       std::string(bytes.substr(begin, end - begin))});
    begin = end + 1;
  }
  for (const MatchRecord& record : records) refusesInOneLine([&] { gameOf(record, "match.plm"); });
  refusesInOneLine([&] {
    GoalMarks marks;
    marks.add(records, "match.plm");
  });
}

/// A whole file, with a page that jumps about in it.
void replayFeed(std::string_view bytes) {
  const std::string path = scratchFile("feed.plm", bytes);
  refusesInOneLine([&] {
    Broadcast broadcast;
    ReplayFeed feed(path, broadcast);
    for (const double time : {feed.duration(), -1.0, 1e300, 0.5 * feed.duration()}) feed.command(Seek{time});
    feed.command(RecordingRate{1e9});
    feed.command(PlayRecording{false});
    const auto latest = broadcast.latest(Channel::replay);
    if (latest.message) require(nlohmann::json::accept(*latest.message), "a page gets what is no JSON");
  });
}

const std::string gameRecord =
    R"({"kind":"game","left":{"name":"A","score":0},"right":{"name":"B","score":1},"mode":"PlayOn","half":1})";

std::vector<std::string> replayGameSeeds() {
  std::string scored = gameRecord;
  scored.replace(scored.find("\"score\":0"), 9, "\"score\":1");
  return {gameRecord + "\n" + scored, gameRecord, std::string(200, '['), R"({"left":{"score":1e999}})"};
}

std::vector<std::string> replayFeedSeeds() {
  const std::string path = scratchFolder() + "/seed.plm";
  std::filesystem::remove(path);
  {
    MatchWriter writer(path);
    for (int i = 0; i < 60; ++i) {
      if (i % 25 == 0) writer.add(0.1 * i, Channel::game, gameRecord);
      writer.add(0.1 * i, Channel::frame, std::string(40, static_cast<char>('a' + i % 9)));
    }
  }
  const std::string bytes = contentOf(path);
  return {bytes, bytes.substr(0, bytes.size() / 2)};
}

const Registered replayGameTarget({"replayGame", replayGame, replayGameSeeds, 10000});
const Registered replayFeedTarget({"replayFeed", replayFeed, replayFeedSeeds, 400});

}  // namespace
}  // namespace plumbline::fuzz
