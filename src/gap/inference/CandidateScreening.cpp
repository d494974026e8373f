#include "gap/inference/CandidateScreening.h"

#include <algorithm>
#include <cmath>

#include "gap/inference/Likelihood.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t mostSamples = 250;  // of a cell that are looked at
constexpr double mostFactor = 4;          // of a start, that its sensitivity is trusted for

bool measured(const Groups& groups, SignalKind a, SignalKind b) {
  return std::ranges::any_of(groups.cells(), [&](const Cell& cell) {
    const SignalKind kind = groups.trials()[cell.trial].signals[cell.signal].kind;
    return kind == a || kind == b;
  });
}

/// Whether recordings of this kind can show an effect at that place at all.
bool canShow(const Groups& groups, const Mechanism& robot, const Effect& effect, const Place& place) {
  const bool free = std::ranges::any_of(groups.trials(), [](const Trial& trial) { return trial.freeBase; });
  switch (place.site) {
    case Site::imu:
      return measured(groups, SignalKind::gyro, SignalKind::accelerometer);
    case Site::foot:
      return measured(groups, SignalKind::force, SignalKind::force);
    case Site::ground:
      return free;
    case Site::link:
      return free || !robot.chain(place.index).empty();
    default:
      break;
  }
  return !effect.canBeAt || effect.canBeAt(robot, place);
}

std::vector<double> thinned(const std::vector<double>& values, std::size_t every) {
  std::vector<double> result;
  for (std::size_t k = 0; k < values.size(); k += every) result.push_back(values[k]);
  return result;
}

}  // namespace

std::size_t CandidateScreening::thinning(const Cell& cell) const {
  return (cell.to - cell.from + mostSamples - 1) / mostSamples;
}

CandidateScreening::CandidateScreening(const Replayer& replayer_, const Shares& shares)
    : replayer(replayer_) {
  const Groups& groups = replayer.groups();
  const Mechanism& robot = replayer.mechanism();
  const Residuals nominal = replayer.residuals({});
  // Most that a cause can gain: every cell of its chains falls to its noise.
  std::vector<double> most(groups.cells().size());
  for (std::size_t c = 0; c < most.size(); ++c) {
    const Cell& cell = groups.cells()[c];
    const std::vector<double> r = residualsOf(cell, nominal);
    const double scale = likeliestScale(r, cell.noise);
    most[c] = std::max(0.0, shares[c] * (static_cast<double>(r.size()) * logDensity({0.0}, cell.noise) -
                                         logDensity(r, scale)));
  }
  std::vector<Cause> possible;
  for (const Effect* effect : effects())
    for (const Place& place : placesOf(*effect, robot)) {
      if (effect->decoded || !canShow(groups, robot, *effect, place)) continue;
      for (int variant = 0; variant < effect->numVariants(); ++variant) {
        possible.push_back({effect, place, 0, variant});
        ++kinds;
      }
    }
  for (Cause cause : possible) {
    double best = 0;
    for (std::size_t c = 0; c < most.size(); ++c) {
      const Cell& cell = groups.cells()[c];
      const Trial& trial = groups.trials()[cell.trial];
      const int joint = trial.signals[cell.signal].joint;
      bool felt = trial.freeBase || (joint < 0 && cause.place.site == Site::imu);
      for (std::size_t chain = 0; chain < replayer.chains().size() && !felt && joint >= 0; ++chain)
        felt = std::ranges::find(replayer.chains()[chain], joint) != replayer.chains()[chain].end() &&
               replayer.feels(chain, cause);
      if (felt) best += most[c];
    }
    if (best <= std::log(static_cast<double>(kinds))) continue;
    for (const double value : cause.effect->starts) {
      cause.value = value * cause.effect->scaleAt(robot, cause.place);
      const Explanation alone = withLogStrengths(robot, {cause}, logStrengths({cause}));
      const Residuals with = replayer.residuals(alone);
      Start start{alone.front(), {}};
      for (std::size_t c = 0; c < groups.cells().size(); ++c) {
        const Cell& cell = groups.cells()[c];
        if (with[cell.trial][cell.signal] == nominal[cell.trial][cell.signal]) continue;
        const std::vector<double> a = thinned(residualsOf(cell, nominal), thinning(cell)),
                                  b = thinned(residualsOf(cell, with), thinning(cell));
        Change change{c, {}};
        bool any = false;
        for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
          const double d = a[k] - b[k];
          change.values.push_back(std::isfinite(d) ? static_cast<float>(d) : 0.F);
          any = any || change.values.back() != 0;
        }
        if (any) start.changes.push_back(std::move(change));
      }
      if (!start.changes.empty()) starts.push_back(std::move(start));
    }
  }
}

double CandidateScreening::gainOf(const Start& start, const std::vector<std::vector<double>>& left,
                                  const std::vector<double>& scales, const std::vector<double>& before,
                                  const Shares& shares, double& share) const {
  double product = 0, squares = 0;
  for (const Change& change : start.changes) {
    const std::vector<double>& r = left[change.cell];
    for (std::size_t k = 0; k < std::min(r.size(), change.values.size()); ++k) {
      if (!std::isfinite(r[k])) continue;
      const double w = shares[change.cell] * weightOf(r[k], scales[change.cell]), d = change.values[k];
      product += w * r[k] * d;
      squares += w * d * d;
    }
  }
  if (!(product > 0) || !(squares > 0)) return 0;
  share = std::clamp(product / squares, 1 / mostFactor, mostFactor);
  double gain = 0;
  for (const Change& change : start.changes) {
    const Cell& cell = replayer.groups().cells()[change.cell];
    std::vector<double> r = left[change.cell];
    for (std::size_t k = 0; k < std::min(r.size(), change.values.size()); ++k)
      r[k] -= share * static_cast<double>(change.values[k]);
    gain += shares[change.cell] * static_cast<double>(thinning(cell)) *
            (logDensity(r, likeliestScale(r, cell.noise)) - before[change.cell]);
  }
  return gain;
}

std::vector<Proposal> CandidateScreening::propose(const Explanation& base, const Shares& shares,
                                                  std::size_t most) const {
  const Groups& groups = replayer.groups();
  const Residuals residuals = replayer.residuals(base);
  std::vector<std::vector<double>> left;
  std::vector<double> scales, before;
  for (const Cell& cell : groups.cells()) {
    left.push_back(thinned(residualsOf(cell, residuals), thinning(cell)));
    scales.push_back(likeliestScale(left.back(), cell.noise));
    before.push_back(logDensity(left.back(), scales.back()));
  }
  std::vector<Proposal> proposals;
  for (const Start& start : starts) {
    if (std::ranges::any_of(base, [&](const Cause& cause) { return cause.sameKind(start.cause); })) continue;
    double share = 1;
    const double gain = gainOf(start, left, scales, before, shares, share);
    if (!(gain > 0)) continue;
    const Eigen::VectorXd x = logStrengths({start.cause}).array() + std::log(share);
    const Proposal proposal{withLogStrengths(replayer.mechanism(), {start.cause}, x).front(), gain};
    const auto same = std::ranges::find_if(proposals, [&](const Proposal& p) {
      return p.cause.sameKind(proposal.cause) && p.cause.variant == proposal.cause.variant;
    });
    if (same == proposals.end())
      proposals.push_back(proposal);
    else if (proposal.gain > same->gain)
      *same = proposal;
  }
  std::ranges::stable_sort(proposals, std::ranges::greater(), &Proposal::gain);
  if (proposals.size() > most) proposals.resize(most);
  return proposals;
}

}  // namespace plumbline::gap
