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

ReplayFeed::ReplayFeed(const std::string& file, Broadcast& broadcast)
    : name_(file), broadcast_(broadcast), reader_(file) {
  seek(0);
  thread_ = std::thread([this] { run(); });
}

ReplayFeed::~ReplayFeed() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void ReplayFeed::command(const PageCommand& command) {
  const std::lock_guard lock(mutex_);
  if (const auto* to = std::get_if<Seek>(&command)) wanted_ = std::min(to->time, reader_.duration());
  if (const auto* play = std::get_if<PlayRecording>(&command)) {
    playing_ = play->playing;
    if (playing_ && time_ >= reader_.duration() - tick) wanted_ = 0;
  }
  if (const auto* to = std::get_if<RecordingRate>(&command)) rate_ = to->rate;
  statusChanged_ = true;
  wake_.notify_all();
}

/// A recorded game is not live, wherever it was recorded.
void ReplayFeed::publish(const MatchRecord& record) {
  if (record.channel != Channel::game) return broadcast_.publish(record.channel, record.message);
  json game = gameOf(record, name_);
  if (!game.is_object()) return;
  game["live"] = false;
  game["source"] = name_;
  game["clock"] = nullptr;
  game["recording"] = "";
  broadcast_.publish(Channel::game, game.dump(-1, ' ', false, json::error_handler_t::replace));
}

void ReplayFeed::load(std::size_t index) {
  records_ = reader_.read(index);
  chunk_ = index;
  next_ = 0;
}

void ReplayFeed::seek(double to) {
  load(reader_.chunkAt(to));
  broadcast_.clear(Channel::drawings);
  std::array<const MatchRecord*, numChannels> shown{};
  const double until = std::max(to, records_.empty() ? 0.0 : records_.front().time);
  // At least the first frame, or the field would show what was there before.
  const auto& frame = shown[static_cast<std::size_t>(Channel::frame)];
  for (; next_ < records_.size() && (records_[next_].time <= until || !frame); ++next_)
    shown[static_cast<std::size_t>(records_[next_].channel)] = &records_[next_];
  for (const MatchRecord* record : shown)
    if (record) publish(*record);
  time_ = to;
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
    for (; next_ < records_.size() && records_[next_].time <= to; ++next_)
      shown[static_cast<std::size_t>(records_[next_].channel)] = &records_[next_];
    if (next_ < records_.size() || chunk_ + 1 >= reader_.numChunks()) break;
    if (to < reader_.beginOf(chunk_ + 1)) break;
    if (to > reader_.endOf(chunk_ + 1)) return seek(to);
    show();
    load(chunk_ + 1);
  }
  show();
  time_ = to;
}

void ReplayFeed::findGoals() {
  if (scanned_ >= reader_.numChunks()) return;
  const std::size_t before = marks_.goals().size();
  try {
    marks_.add(reader_.read(scanned_++), name_);
  } catch (const std::runtime_error&) {  // whoever goes there gets the error
    scanned_ = reader_.numChunks();
  }
  if (marks_.goals().size() != before) statusChanged_ = true;
}

void ReplayFeed::publishStatus() {
  json goals = json::array();
  for (const GoalMarks::Goal& goal : marks_.goals())
    goals.push_back({{"time", goal.time}, {"side", goal.left ? "left" : "right"}});
  broadcast_.publish(Channel::replay, json{{"kind", "replay"},
                                           {"time", time_},
                                           {"duration", reader_.duration()},
                                           {"playing", playing_},
                                           {"rate", rate_},
                                           {"goals", std::move(goals)},
                                           {"problem", problem_}}
                                          .dump());
}

void ReplayFeed::run() {
  auto last = Clock::now();
  auto lastStatus = last - std::chrono::seconds(1);
  std::unique_lock lock(mutex_);
  while (!stop_) {
    const auto now = Clock::now();
    const double elapsed = std::chrono::duration<double>(now - last).count();
    last = now;
    try {
      if (wanted_) {
        seek(*wanted_);
        wanted_.reset();
        statusChanged_ = true;
      } else if (playing_) {
        advance(std::min(time_ + elapsed * rate_, reader_.duration()));
        if (time_ >= reader_.duration()) {
          playing_ = false;
          statusChanged_ = true;
        }
      }
    } catch (const std::runtime_error& error) {  // the file is broken here
      problem_ = error.what();
      playing_ = false;
      wanted_.reset();
      statusChanged_ = true;
    }
    findGoals();
    if (statusChanged_ || (playing_ && now - lastStatus > std::chrono::duration<double>(statusInterval))) {
      publishStatus();
      lastStatus = now;
      statusChanged_ = false;
    }
    if (playing_ || scanned_ < reader_.numChunks()) {
      wake_.wait_for(lock, std::chrono::duration<double>(tick));
    } else {
      wake_.wait(lock, [&] { return stop_ || playing_ || wanted_ || statusChanged_; });
      last = Clock::now();
    }
  }
}

}  // namespace plumbline::web
