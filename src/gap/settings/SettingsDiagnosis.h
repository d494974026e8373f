#pragma once
#include <functional>
#include <string>
#include <vector>

#include "gap/diagnosis/Diagnosis.h"
#include "gap/settings/TraceEvidence.h"

namespace plumbline::gap {

/// A setting that would explain nearly as well.
struct SettingRival {
  SettingValue value;
  double probability = 0;
};

/// A wrong setting of the nominal simulator.
struct SettingFinding {
  SettingValue value;
  double nominal = 0;
  double lower = 0, upper = 0;  ///< smallest and largest value of the fits to each robot type alone
  double probability = 0;
  double closedAlone = 0, closedLast = 0;  ///< share of the gap in what is left out
  std::vector<SettingRival> rivals;        ///< most probable first
};

/// One signal in one kind of motion, on all windows: typical errors [SI units].
struct SettingCell {
  std::string signal, motion, unit;
  double gap = 0, floor = 0, after = 0;
  double share = 0;  ///< of the whole excess, in units of the floor
};

struct SettingsDiagnosis {
  Verdict verdict = Verdict::none;
  std::vector<SettingFinding> findings;
  GapSize gap;  ///< typical error on left-out windows, root mean square over signals in units of what the
                ///< method itself leaves
  double knownProbability = 1;
  std::vector<SettingCell> cells;  ///< largest share first
  std::string nextMotion;
  std::size_t windows = 0, leftOutWindows = 0;
};

struct SettingsOptions {
  int jobs = 1;
  std::size_t maxSettings = 4;
  std::uint64_t seed = 1;  ///< of the resampling
  std::function<void(const std::string& stage, double share)> progress = {};
};

/// Finds the settings of the nominal simulator that do not fit the recordings. Every setting is scanned over
/// its range on windows for fitting, its value is fitted (minimizeBrent), and it is judged on left-out
/// recordings. A window counts by the logarithm of its error, because a single contact must not decide.
/// Settings are added while each improves most left-out recordings; then each is searched again together with
/// the others. A probability is the share of resampled sets of left-out recordings in which the setting does
/// best, at most (n+1)/(n+2) with n recordings (Laplace), times the probability that settings explain the gap
/// at all.
SettingsDiagnosis diagnoseSettings(const TraceEvidence& evidence, const SimulatorSetup& nominal,
                                   const SettingsOptions& options);

}  // namespace plumbline::gap
