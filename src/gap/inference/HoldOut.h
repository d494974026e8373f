#pragma once
#include <string>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// Root mean squares of what a signal's predictions leave [its unit].
struct SignalLeft {
  std::string signal;
  bool position = false;
  double before = 0, after = 0, floor = 0;  ///< nominal, with the causes, what repeats differ by
  bool hasFloor = false;
  double samples = 0;
};

/// The same of a recording: of its positions together [rad, or m].
struct RecordingLeft {
  std::string folder;
  std::vector<SignalLeft> signals;
  double before = 0, after = 0, floor = 0;
  bool hasFloor = false;
  bool fellBefore = false, fellAfter = false;  ///< the replay fell
  double closed() const { return before > floor ? (before - after) / (before - floor) : 0; }
};

/// Values that hold from a cycle on.
struct From {
  std::size_t cycle = 0;
  Explanation causes;
};

/// Replays a recording free from its first sample, with the nominal model and with causes (others may hold
/// for other stretches of it), and compares.
RecordingLeft leftIn(const Trial& trial, const std::vector<From>& causes);

/// Sums stretches or windows of one recording up.
RecordingLeft together(const std::vector<RecordingLeft>& parts);

/// Puts the floor in where recordings are repeats of each other.
void putFloors(const std::vector<Trial>& trials, std::vector<RecordingLeft>& recordings);

/// Mean of closed() over recordings.
double meanClosed(const std::vector<RecordingLeft>& recordings);

}  // namespace plumbline::gap
