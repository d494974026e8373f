#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "gap/replay/Replay.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// What is left is a gap from this many times its floor on.
inline constexpr double gapShown = 1.1;

/// Root mean squares of what a signal's predictions leave [its unit].
struct SignalLeft {
  std::string signal;
  bool position = false;
  double before = 0, after = 0, floor = 0;  ///< nominal, with the causes, what repeats differ by
  bool hasFloor = false;
  double samples = 0;
  double noise = 0;  ///< of the readings, as the channel itself shows it

  double noiseFloor() const { return std::max(floor, noise); }
  bool showsGap() const { return before > gapShown * noiseFloor(); }
};

/// The same of a recording: of its positions together [rad, or m].
struct RecordingLeft {
  std::string folder;
  std::vector<SignalLeft> signals;
  double before = 0, after = 0, floor = 0;
  bool hasFloor = false;
  bool fellBefore = false, fellAfter = false;  ///< the replay fell
  double noise = 0;
  double closed() const { return before > floor ? (before - after) / (before - floor) : 0; }
  /// Of what is above the noise as well: repeats are rounded alike, and what no model closes is no gap.
  double noiseFloor() const { return std::max(floor, noise); }
  bool showsGap() const { return before > gapShown * noiseFloor(); }
  double closedToNoise() const {
    return before > noiseFloor() ? std::min(1.0, (before - after) / (before - noiseFloor())) : 0;
  }
};

/// Values that hold from a cycle on.
struct From {
  std::size_t cycle = 0;
  Explanation causes;
};

/// Replays a recording free from its first sample, with the nominal model and with causes (others may hold
/// for other stretches of it), and compares.
RecordingLeft leftIn(const Trial& trial, const std::vector<From>& causes);
/// The same with the nominal model's replay, which was made before.
RecordingLeft leftIn(const Trial& trial, const Prediction& nominal, const std::vector<From>& causes);

/// Sums stretches or segments of one recording up.
RecordingLeft together(const std::vector<RecordingLeft>& parts);

/// Puts the floor in where recordings are repeats of each other.
void putFloors(const std::vector<Trial>& trials, std::vector<RecordingLeft>& recordings);

/// Puts the noise in of each signal that a trial of the recording has.
void putNoise(const std::vector<Trial>& trials, std::vector<RecordingLeft>& recordings);

/// Mean of closed() over recordings, and of closedToNoise().
double meanClosed(const std::vector<RecordingLeft>& recordings);
double meanClosedToNoise(const std::vector<RecordingLeft>& recordings);

}  // namespace plumbline::gap
