#pragma once
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "framework/SpecialModule.h"

namespace plumbline::record {

struct LogReplayOptions {
  double speed = 0;     ///< as fast as the clock of the log times this; 0: as fast as it goes
  bool paused = false;  ///< begins before the first cycle, and stays at the end
};

/// Position and target of a replay, for all threads of an agent. The player added first leads: positions are
/// its cycles, and the others follow to its time. Going back means to restart and to play up to that position
/// as fast as possible, because only this restores the modules' state.
class ReplayControl {
public:
  using Turn = SpecialModule::Turn;

  ReplayControl(std::string path, LogReplayOptions options);

  const std::string& path() const { return path_; }
  /// At the end of the log it waits for a new target instead of ending the agent.
  bool stays() const { return stays_; }
  /// Before the first cycle; `timestamps` of its cycles, in order [ns]. Returns the player's number.
  std::size_t addPlayer(std::vector<std::int64_t> timestamps);

  /// Asked by a player before each cycle; `played`: how many it has. `restart`: it starts again with its
  /// first; `unseen`: on the way to the target of the replay. Sleeps until the next cycle is
  /// due, or for 50 ms if the replay is paused.
  Turn next(std::size_t player, std::size_t played);
  /// A player has played a cycle. True: all have played all, and the replay does not stay.
  bool played(std::size_t player, std::size_t played);

  /// Whether the replay is on the way to its target.
  bool jumps() const;
  bool paused() const;
  void pause(bool paused);
  double speed() const;
  void setSpeed(double speed);
  /// Cycles that the leading player has played.
  std::size_t position() const;
  std::size_t cycles() const;
  /// Of the leading player's last cycle; of the first before it [s].
  double time() const;
  /// Of the leading player's first and last cycle [s].
  std::pair<double, double> span() const;
  /// Plays up to this number of cycles, 0 to cycles(), and continues or pauses there.
  void goTo(std::size_t cycle);
  /// The same, to the last cycle not later than this.
  void goToTime(double time);
  /// Moves on by this number of cycles, or back if negative; pauses there.
  void step(long cycles);

private:
  using Clock = std::chrono::steady_clock;
  struct Player {
    std::vector<std::int64_t> timestamps;
    std::size_t played = 0;
    std::uint64_t generation = 0;
  };

  bool due(const Player& player, std::size_t played) const;
  void go(std::size_t cycle);
  std::size_t countUntil(const Player& player, std::int64_t timestamp) const;

  std::string path_;
  bool stays_;
  mutable std::mutex mutex_;
  std::vector<Player> players_;
  bool paused_;
  double speed_;
  std::size_t target_ = 0;  ///< rests there when paused; is reached as fast as it goes
  std::uint64_t generation_ = 0;
  Clock::time_point paceBegin_{};
  std::int64_t paceTimestamp_ = 0;
  bool paced_ = false;
};

}  // namespace plumbline::record
