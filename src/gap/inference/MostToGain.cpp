#include "gap/inference/MostToGain.h"

#include <algorithm>
#include <cmath>

#include "gap/inference/Likelihood.h"
#include "gap/inference/Score.h"

namespace plumbline::gap {

namespace {

constexpr double farBeyond = 3;  // times the noise: one of 400 normal values

}  // namespace

MostOfCell::MostOfCell(const Split& left, const StretchFit& fit, double share)
    : isAtNoise(std::abs(left.mean) <= fit.noise && fit.scale <= fit.noise) {
  const double most = isAtNoise ? farBeyond * fit.noise : 0;
  Split nothing = left;
  for (double& of : nothing.about) of = std::isfinite(of) ? std::clamp(of, -most, most) : of;
  if (!isAtNoise) nothing.mean = 0;
  gain = std::max(0.0, stretchDensity(nothing, fit.noise, share) - fit.density(share));
}

MostToGain::MostToGain(const Replayer& replayer, const Shares& shares, std::size_t kinds)
    : replayer_(replayer),
      price_(priceOf(1, kinds)),
      most_(replayer.groups().cells().size(), 0.0),
      enough_(enoughTrials(replayer.groups())) {
  const Residuals nominal = replayer.residuals({});
  for (std::size_t c = 0; c < most_.size(); ++c) {
    const Cell& cell = replayer.groups().cells()[c];
    const Split left = split(residualsOf(cell, nominal));
    most_[c] = MostOfCell(left, fitStretch(left, cell.noise), shares[c]).gain;
  }
}

/// Whether the cell is of a joint on the cause's chain, or of a sensor that the cause is at.
bool MostToGain::isNear(const Cell& cell, const Cause& cause) const {
  const int joint = replayer_.groups().trials()[cell.trial].signals[cell.signal].joint;
  if (joint < 0) return cause.place.site == Site::imu;
  for (std::size_t chain = 0; chain < replayer_.chains().size(); ++chain) {
    const std::vector<int>& joints = replayer_.chains()[chain];
    if (std::ranges::find(joints, joint) != joints.end() && replayer_.feels(chain, cause)) return true;
  }
  return false;
}

std::vector<char> MostToGain::trialsFor(const Cause& cause) const {
  const std::vector<Trial>& trials = replayer_.groups().trials();
  std::vector<double> felt(trials.size(), 0.0), near(trials.size(), 0.0);
  double all = 0;
  for (std::size_t c = 0; c < most_.size(); ++c) {
    const Cell& cell = replayer_.groups().cells()[c];
    const bool own = isNear(cell, cause);
    if (own) near[cell.trial] += most_[c];
    if (own || trials[cell.trial].freeBase) felt[cell.trial] += most_[c], all += most_[c];
  }
  std::vector<char> flags(trials.size(), 0);
  if (all <= price_) return flags;
  const bool anyFree = std::ranges::any_of(trials, &Trial::freeBase);
  const bool local =
      cause.place.site == Site::joint ||
      (cause.place.site == Site::link && !replayer_.mechanism().chain(cause.place.index).empty());
  std::size_t best = trials.size();
  for (std::size_t t = 0; t < trials.size(); ++t) {
    flags[t] = enough_[t] && (!anyFree || felt[t] > 0);
    if (!local || !trials[t].freeBase || !flags[t]) continue;
    flags[t] = 0;
    if (near[t] > 0 && (best == trials.size() || near[t] > near[best])) best = t;
  }
  if (best < trials.size()) flags[best] = 1;
  return flags;
}

}  // namespace plumbline::gap
