#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "gap/replay/Replay.h"
#include "gap/replay/Stepper.h"

namespace plumbline::gap {

/// A plant that plays a trial, cycle by cycle. A copy goes on by itself, as a guess about lost commands does,
/// as long as the base is held. Plant and trial must outlive it.
class Playback {
public:
  /// What a joint's sensor shows.
  struct Shown {
    std::size_t signal, cycle;
    double value;
  };

  Playback(const Plant& plant, const Trial& trial, const ReplayOptions& options);

  /// Comes to rest under the first command; what is read before the first cycle is played.
  const std::vector<Shown>& settle();
  /// Plays the cycle up to the next, or to its last reading; what is read meanwhile. In ascending order.
  const std::vector<Shown>& play(std::size_t cycle);
  /// From now on the commands of other cycles never come; must outlive it. Null: all come.
  void lose(const std::vector<std::uint8_t>* lostCycles) { stepper_.lose(lostCycles); }

  bool reads(std::size_t signal) const;  ///< of the joints that are played
  double time() const { return t_; }
  Stepper& body() { return stepper_; }

private:
  /// Where a joint's readings go, and the next cycle that is due.
  struct Reading {
    std::size_t signal = 0;
    int node = 0;  ///< of the stepper
    SignalKind kind = SignalKind::position;
    double shift = 0;  ///< when in the cycle [s]
    bool unsignedValue = false;
    std::size_t next = 0;
    const Signal* seen = nullptr;  ///< of a duty: the same joint's measured position, if there is one
  };

  void read(double from, double to);
  double valueOf(const Reading& reading, double h, double s) const;
  /// A duty is what the servo makes of the angle that was measured: what moves the joint has no say in it.
  double dutyIn(const Reading& reading) const;

  const Trial& trial_;
  std::shared_ptr<const Plant> plant_;
  Stepper stepper_;
  double longest_, settleFor_, t_, lastShift_ = 0;
  std::vector<Reading> readings_;
  std::vector<Shown> due_;
};

}  // namespace plumbline::gap
