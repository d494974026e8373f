#include "record/ReplayControl.h"

#include <algorithm>
#include <cmath>
#include <thread>

namespace plumbline::record {

namespace {
constexpr std::chrono::milliseconds rest{50};
constexpr double longestSleep = 0.05;  ///< [s]
}  // namespace

ReplayControl::ReplayControl(std::string path, LogReplayOptions options)
    : path_(std::move(path)), stays_(options.paused), paused_(options.paused), speed_(options.speed) {}

std::size_t ReplayControl::addPlayer(std::vector<std::int64_t> timestamps) {
  const std::lock_guard lock(mutex_);
  players_.push_back({std::move(timestamps), 0, generation_});
  return players_.size() - 1;
}

std::size_t ReplayControl::countUntil(const Player& player, std::int64_t timestamp) const {
  return static_cast<std::size_t>(std::ranges::upper_bound(player.timestamps, timestamp) -
                                  player.timestamps.begin());
}

bool ReplayControl::due(const Player& player, std::size_t played) const {
  if (played >= player.timestamps.size()) return false;
  const Player& leader = players_.front();
  const std::size_t limit = paused_ ? target_ : leader.timestamps.size();
  if (&player == &leader) return played < limit;
  if (limit >= leader.timestamps.size()) return true;
  return limit > 0 && player.timestamps[played] <= leader.timestamps[limit - 1];
}

ReplayControl::Turn ReplayControl::next(std::size_t index, std::size_t played) {
  for (;;) {
    std::chrono::duration<double> wait = rest;
    {
      const std::lock_guard lock(mutex_);
      Player& player = players_[index];
      if (player.generation != generation_) {
        player.generation = generation_;
        player.played = 0;
        return Turn::restart;
      }
      if (due(player, played)) {
        const bool jumps = (index == 0 ? played : players_.front().played) < target_;
        if (jumps || speed_ <= 0) {
          paced_ = false;
          return jumps ? Turn::unseen : Turn::cycle;
        }
        const std::int64_t timestamp = player.timestamps[played];
        if (!paced_) {
          paced_ = true;
          paceBegin_ = Clock::now();
          paceTimestamp_ = timestamp;
        }
        const double ahead = 1e-9 * static_cast<double>(timestamp - paceTimestamp_) / speed_ -
                             std::chrono::duration<double>(Clock::now() - paceBegin_).count();
        if (ahead <= 0) return Turn::cycle;
        // Not longer: somebody may end the agent, or want something else.
        if (ahead <= longestSleep) wait = std::chrono::duration<double>(ahead);
      }
    }
    std::this_thread::sleep_for(wait);
    const std::lock_guard lock(mutex_);
    if (players_[index].generation == generation_ && !due(players_[index], played)) return Turn::wait;
    if (wait == rest) return Turn::wait;
  }
}

bool ReplayControl::played(std::size_t index, std::size_t played) {
  const std::lock_guard lock(mutex_);
  players_[index].played = played;
  return !stays_ &&
         std::ranges::all_of(players_, [](const Player& p) { return p.played >= p.timestamps.size(); });
}

bool ReplayControl::jumps() const {
  const std::lock_guard lock(mutex_);
  return players_.front().played < target_;
}

bool ReplayControl::paused() const {
  const std::lock_guard lock(mutex_);
  return paused_;
}

void ReplayControl::pause(bool paused) {
  const std::lock_guard lock(mutex_);
  paused_ = paused;
  paced_ = false;
  target_ = players_.front().played;
}

double ReplayControl::speed() const {
  const std::lock_guard lock(mutex_);
  return speed_;
}

void ReplayControl::setSpeed(double speed) {
  const std::lock_guard lock(mutex_);
  speed_ = speed;
  paced_ = false;
}

std::size_t ReplayControl::position() const {
  const std::lock_guard lock(mutex_);
  return players_.front().played;
}

std::size_t ReplayControl::cycles() const {
  const std::lock_guard lock(mutex_);
  return players_.front().timestamps.size();
}

double ReplayControl::time() const {
  const std::lock_guard lock(mutex_);
  const Player& leader = players_.front();
  if (leader.timestamps.empty()) return 0;
  return static_cast<double>(leader.timestamps[leader.played > 0 ? leader.played - 1 : 0]) / 1e9;
}

std::pair<double, double> ReplayControl::span() const {
  const std::lock_guard lock(mutex_);
  const std::vector<std::int64_t>& timestamps = players_.front().timestamps;
  if (timestamps.empty()) return {0, 0};
  return {static_cast<double>(timestamps.front()) / 1e9, static_cast<double>(timestamps.back()) / 1e9};
}

void ReplayControl::go(std::size_t cycle) {
  const Player& leader = players_.front();
  target_ = std::min(cycle, leader.timestamps.size());
  paced_ = false;
  if (target_ < leader.played) {
    generation_++;
    for (Player& player : players_) player.played = 0;
  }
}

void ReplayControl::goTo(std::size_t cycle) {
  const std::lock_guard lock(mutex_);
  go(cycle);
}

void ReplayControl::goToTime(double time) {
  const std::lock_guard lock(mutex_);
  const double nanoseconds = std::round(1e9 * std::clamp(time, -9e9, 9e9));
  go(countUntil(players_.front(), static_cast<std::int64_t>(nanoseconds)));
}

void ReplayControl::step(long cycles) {
  const std::lock_guard lock(mutex_);
  paused_ = true;
  const auto from = static_cast<long>(players_.front().played);
  go(static_cast<std::size_t>(std::max(0L, from + cycles)));
}

}  // namespace plumbline::record
