#pragma once
#include <string>
#include <vector>

#include "gap/diagnosis/Evaluator.h"
#include "gap/diagnosis/Phases.h"

namespace plumbline::gap {

/// The place of a gap: a signal in a phase.
struct GapCell {
  std::string signal;
  Phase phase = Phase::motion;
  double gap = 0;    ///< root mean square of measured minus predicted, in the signal's unit
  double noise = 0;  ///< what it would be without any cause
  double share = 0;  ///< of the whole gap beyond noise, all signals in units of their noise
  std::size_t samples = 0;
};

/// When: one value per half second of a run, root mean square over all channels in units of noise.
struct GapTrack {
  std::size_t trial = 0;
  std::vector<double> start, size;
};

/// One signal over all runs, on blocks that took no part in a fit.
struct SignalGap {
  std::string signal;
  double before = 0, after = 0, floor = 0;  ///< in the signal's unit
};

/// Cells by share, largest first; those without samples left out. Uses the evaluator's base.
std::vector<GapCell> gapCells(const Evaluator& evaluator);
std::vector<GapTrack> gapTracks(const Evaluator& evaluator);
/// before: predictions of the nominal model; after: the evaluator's base.
std::vector<SignalGap> signalGaps(const Evaluator& evaluator, const std::vector<Prediction>& before);

}  // namespace plumbline::gap
