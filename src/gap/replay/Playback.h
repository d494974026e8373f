#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "gap/replay/Replay.h"
#include "gap/replay/Stepper.h"

namespace plumbline::gap {

/// A plant that plays a trial, cycle by cycle. With a fixed base a copy continues independently, for another
/// hypothesis about lost commands. Plant and trial must outlive it.
class Playback {
public:
  /// Reading of a joint's sensor.
  struct Shown {
    std::size_t signal, cycle;
    double value;
  };

  Playback(const Plant& plant, const Trial& trial, const ReplayOptions& options);

  /// Settles under the first command; returns the readings before the first cycle.
  const std::vector<Shown>& settle();
  /// Plays a cycle up to the next, or to its last reading; returns the readings. Call in ascending order.
  const std::vector<Shown>& play(std::size_t cycle) { return playTo(cycle); }
  /// The same for a cycle and those after it up to a last one, in steps that need not end with each of them.
  const std::vector<Shown>& playTo(std::size_t lastCycle);
  /// The last cycle that ends within one step from this one's begin: of a log that is faster than the
  /// integrator. The cycle itself where efforts or the body are read, or the state is put in.
  std::size_t lastInStep(std::size_t cycle) const;
  /// Changes which cycles' commands are lost from now on; the list must outlive this object. Null: unknown.
  void lose(const std::vector<std::uint8_t>* lostCycles) { stepper_.lose(lostCycles); }

  bool reads(std::size_t signal) const;  ///< of the joints that are played
  double time() const { return t_; }
  Stepper& body() { return stepper_; }

private:
  /// Where a joint's readings are stored, and its next cycle.
  struct Reading {
    std::size_t signal = 0;
    int node = 0;  ///< of the stepper
    SignalKind kind = SignalKind::position;
    double shift = 0;  ///< when in the cycle [s]
    bool unsignedValue = false, ofSupply = false;
    std::size_t next = 0;
    const Signal* seen = nullptr;  ///< of an effort: the same joint's measured position, if there is one
  };
  /// What the encoder shows at an effort's reading [rad, rad/s].
  struct Seen {
    double shown, rate;
  };

  void read(double from, double to);
  double valueOf(const Reading& reading, double h, double s) const;
  /// Duty, torque and current follow from the measured angle by the servo's law: given the positions, the
  /// joint's dynamics do not matter.
  double dutyIn(const Reading& reading) const;
  double torqueIn(const Reading& reading, const Seen& seen) const;
  double currentIn(const Reading& reading) const;
  Seen seenAt(const Reading& reading) const;

  const Trial& trial_;
  std::shared_ptr<const Plant> plant_;
  Stepper stepper_;
  double longest_, settleFor_, t_, lastShift_ = 0;
  /// Efforts are read, for which the command then in force counts: steps end with each cycle.
  bool readsEfforts_ = false;
  bool mayCross_, acrossCycles_;
  std::vector<Reading> readings_;
  /// When the next of them is due, as far as is known [s].
  double nextRead_ = -std::numeric_limits<double>::infinity();
  std::vector<Shown> due_;
};

}  // namespace plumbline::gap
