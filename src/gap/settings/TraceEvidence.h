#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "gap/settings/TracePlay.h"

namespace plumbline::gap {

/// Compared signals, in groups with equal weight.
enum class TraceSignal { torsoPosition, torsoRotation, joints, gyro, accelerometer, footForce };
constexpr std::size_t numTraceSignals = 6;
const char* nameOf(TraceSignal signal);
const char* unitOf(TraceSignal signal);

/// A piece of a recording that is replayed separately from the measured state, so that chaotic contacts do
/// not hide the effect of a wrong setting.
struct TraceWindow {
  std::size_t trace = 0, first = 0, rows = 0;
  bool leftOut = false;
};

/// Error of a replay of a window, per signal: mean square over rows and components [SI units squared].
using WindowError = std::array<double, numTraceSignals>;

/// Mean of each signal over windows without the largest tenth, where a contact came a cycle earlier or later:
/// square root, at least half the recordings' last digit [SI units].
WindowError typicalError(const std::vector<WindowError>& errors);

/// Recordings divided into windows; windows without motion are left out. All recordings of every second robot
/// type are left out (every second recording if there is only one type).
class TraceEvidence {
public:
  /// Error: ConfigurationError if nothing can be fitted or nothing left out.
  explicit TraceEvidence(std::vector<simspark::LeagueTrace> traces, std::size_t rowsPerWindow = 5,
                         std::size_t rowsBetweenStarts = 24);

  const std::vector<simspark::LeagueTrace>& traces() const { return recordings_; }
  const std::vector<TraceWindow>& windows() const { return cut_; }
  bool leftOut(std::size_t trace) const { return leftOut_[trace]; }

  WindowError errorOf(const TraceWindow& window, const SimulatorSetup& setup) const;

  /// Error of the method itself, per window: the setup's own free runs with the recordings' commands, rounded
  /// like recordings, are replayed in the same windows by the same setup.
  std::vector<WindowError> ownErrors(const SimulatorSetup& setup, int jobs) const;

private:
  std::vector<simspark::LeagueTrace> recordings_;
  std::vector<TraceWindow> cut_;
  std::vector<bool> leftOut_;
};

/// All recordings *.csv.gz of a moving robot in a folder (the name ends in _t0 to _t4), without those of a
/// ball that rolls alone or against a robot at rest. Error: ConfigurationError that names the folder.
std::vector<simspark::LeagueTrace> readTraces(const std::filesystem::path& folder);

}  // namespace plumbline::gap
