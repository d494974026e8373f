#include "web/ReplayFeed.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace plumbline::web {

using nlohmann::json;
using Clock = std::chrono::steady_clock;

namespace {
constexpr double tick = 0.02, statusInterval = 0.2;
}

ReplayFeed::ReplayFeed(const std::string& file, Broadcast& broadcast_)
    : name(file), broadcast(broadcast_), reader(file) {
  seek(0);
  thread = std::thread([this] { run(); });
}

ReplayFeed::~ReplayFeed() {
  {
    const std::lock_guard lock(mutex);
    stop = true;
  }
  wake.notify_all();
  thread.join();
}

void ReplayFeed::command(const PageCommand& command) {
  const std::lock_guard lock(mutex);
  if (const auto* to = std::get_if<Seek>(&command)) wanted = std::min(to->time, reader.duration());
  if (const auto* play = std::get_if<PlayRecording>(&command)) {
    playing = play->playing;
    if (playing && time >= reader.duration() - tick) wanted = 0;
  }
  if (const auto* to = std::get_if<RecordingRate>(&command)) rate = to->rate;
  statusChanged = true;
  wake.notify_all();
}

/// A recorded game is not live, wherever it was recorded.
void ReplayFeed::publish(const MatchRecord& record) {
  if (record.channel != Channel::game) return broadcast.publish(record.channel, record.message);
  json game = gameOf(record, name);
  if (!game.is_object()) return;
  game["live"] = false;
  game["source"] = name;
  game["clock"] = nullptr;
  game["recording"] = "";
  broadcast.publish(Channel::game, game.dump(-1, ' ', false, json::error_handler_t::replace));
}

void ReplayFeed::load(std::size_t index) {
  records = reader.read(index);
  chunk = index;
  next = 0;
}

void ReplayFeed::seek(double to) {
  load(reader.chunkAt(to));
  broadcast.clear(Channel::drawings);
  std::array<const MatchRecord*, numChannels> shown{};
  const double until = std::max(to, records.empty() ? 0.0 : records.front().time);
  // At least the first frame, or the field would show what was there before.
  const auto& frame = shown[static_cast<std::size_t>(Channel::frame)];
  for (; next < records.size() && (records[next].time <= until || !frame); ++next)
    shown[static_cast<std::size_t>(records[next].channel)] = &records[next];
  for (const MatchRecord* record : shown)
    if (record) publish(*record);
  time = to;
}

void ReplayFeed::advance(double to) {
  std::array<const MatchRecord*, numChannels> shown{};
  const auto show = [&] {
    for (const MatchRecord*& record : shown) {
      if (record) publish(*record);
      record = nullptr;
    }
  };
  for (;;) {
    for (; next < records.size() && records[next].time <= to; ++next)
      shown[static_cast<std::size_t>(records[next].channel)] = &records[next];
    if (next < records.size() || chunk + 1 >= reader.numChunks()) break;
    if (to < reader.beginOf(chunk + 1)) break;
    if (to > reader.endOf(chunk + 1)) return seek(to);
    show();
    load(chunk + 1);
  }
  show();
  time = to;
}

void ReplayFeed::findGoals() {
  if (scanned >= reader.numChunks()) return;
  const std::size_t before = marks.goals().size();
  try {
    marks.add(reader.read(scanned++), name);
  } catch (const std::runtime_error&) {  // whoever goes there is told
    scanned = reader.numChunks();
  }
  if (marks.goals().size() != before) statusChanged = true;
}

void ReplayFeed::publishStatus() {
  json goals = json::array();
  for (const GoalMarks::Goal& goal : marks.goals())
    goals.push_back({{"time", goal.time}, {"side", goal.left ? "left" : "right"}});
  broadcast.publish(Channel::replay, json{{"kind", "replay"},
                                          {"time", time},
                                          {"duration", reader.duration()},
                                          {"playing", playing},
                                          {"rate", rate},
                                          {"goals", std::move(goals)},
                                          {"problem", problem}}
                                         .dump());
}

void ReplayFeed::run() {
  auto last = Clock::now();
  auto lastStatus = last - std::chrono::seconds(1);
  std::unique_lock lock(mutex);
  while (!stop) {
    const auto now = Clock::now();
    const double elapsed = std::chrono::duration<double>(now - last).count();
    last = now;
    try {
      if (wanted) {
        seek(*wanted);
        wanted.reset();
        statusChanged = true;
      } else if (playing) {
        advance(std::min(time + elapsed * rate, reader.duration()));
        if (time >= reader.duration()) {
          playing = false;
          statusChanged = true;
        }
      }
    } catch (const std::runtime_error& error) {  // the file is broken here
      problem = error.what();
      playing = false;
      wanted.reset();
      statusChanged = true;
    }
    findGoals();
    if (statusChanged || (playing && now - lastStatus > std::chrono::duration<double>(statusInterval))) {
      publishStatus();
      lastStatus = now;
      statusChanged = false;
    }
    if (playing || scanned < reader.numChunks()) {
      wake.wait_for(lock, std::chrono::duration<double>(tick));
    } else {
      wake.wait(lock, [&] { return stop || playing || wanted || statusChanged; });
      last = Clock::now();
    }
  }
}

}  // namespace plumbline::web
