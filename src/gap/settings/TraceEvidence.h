#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "gap/settings/TracePlay.h"

namespace plumbline::gap {

/// What is compared, in groups that count alike.
enum class TraceSignal { torsoPosition, torsoRotation, joints, gyro, accelerometer, footForce };
constexpr std::size_t numTraceSignals = 6;
const char* nameOf(TraceSignal signal);
const char* unitOf(TraceSignal signal);

/// A piece of a recording that is replayed on its own from the measured state, so that the chaos of contacts
/// does not drown what is missing.
struct TraceWindow {
  std::size_t trace = 0, first = 0, rows = 0;
  bool heldOut = false;
};

/// How far a replay is from a window, per signal: mean square over rows and components [SI units squared].
using WindowError = std::array<double, numTraceSignals>;

/// Mean of each signal over windows without the largest tenth, where a contact came a cycle earlier or later:
/// square root, at least half the recordings' last digit [SI units].
WindowError typicalError(const std::vector<WindowError>& errors);

/// Recordings cut into windows; those in which nothing moves are left out. Every other robot type is held out
/// (every other recording where there is one type only), with all its recordings.
class TraceEvidence {
public:
  /// Error: ConfigurationError where nothing can be fitted or nothing held out.
  explicit TraceEvidence(std::vector<simspark::LeagueTrace> traces, std::size_t rowsPerWindow = 5,
                         std::size_t rowsBetweenStarts = 24);

  const std::vector<simspark::LeagueTrace>& traces() const { return recordings_; }
  const std::vector<TraceWindow>& windows() const { return cut_; }
  bool heldOut(std::size_t trace) const { return held_[trace]; }

  WindowError errorOf(const TraceWindow& window, const SimulatorSetup& setup) const;

  /// What the method itself leaves, per window: the setup's own free runs of the recordings' commands,
  /// rounded as recordings are, replayed in the same windows by the same setup.
  std::vector<WindowError> ownErrors(const SimulatorSetup& setup, int jobs) const;

private:
  std::vector<simspark::LeagueTrace> recordings_;
  std::vector<TraceWindow> cut_;
  std::vector<bool> held_;
};

/// All recordings *.csv.gz of a folder that are of a robot (the name ends in _t0 to _t4), balls rolling alone
/// or against a robot at rest aside. Error: ConfigurationError that names the folder.
std::vector<simspark::LeagueTrace> readTraces(const std::filesystem::path& folder);

}  // namespace plumbline::gap
