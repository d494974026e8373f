#include "gap/inference/CandidateScreening.h"

#include <algorithm>
#include <cmath>

#include "gap/inference/Likelihood.h"
#include "gap/inference/Strengths.h"

namespace plumbline::gap {

namespace {

constexpr double enoughSeconds = 30;      // of recordings, for screening
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

/// Windows and repeats of recordings, one of each after the other, until they are long enough to tell causes
/// apart; at least one trial of each group.
std::vector<char> someTrials(const Groups& groups) {
  const std::vector<Trial>& trials = groups.trials();
  std::vector<char> taken(trials.size(), 0);
  std::vector<std::size_t> windows(groups.count(), 0);
  std::vector<std::pair<std::size_t, std::size_t>> order;  // how many of its group came before, trial
  for (std::size_t t = 0; t < trials.size(); ++t) {
    std::size_t group = 0;
    while (group < groups.count() && !groups.holds(group, t)) ++group;
    if (group < groups.count()) order.emplace_back(windows[group]++, t);
  }
  std::ranges::sort(order);
  double seconds = 0;
  for (const auto& [window, t] : order) {
    if (window > 0 && seconds > enoughSeconds) break;
    taken[t] = 1;
    seconds += trials[t].time.back() - trials[t].time.front();
  }
  return taken;
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

CandidateScreening::CandidateScreening(const Replayer& replayer_, const Shares& shares,
                                       const std::function<void(double)>& progress)
    : replayer(replayer_), looked(someTrials(replayer_.groups())) {
  const Groups& groups = replayer.groups();
  const Mechanism& robot = replayer.mechanism();
  const Residuals nominal = replayer.residuals({});
  // Most that a cause can gain: every cell of its chains falls to its noise.
  std::vector<double> most(groups.cells().size());
  for (std::size_t c = 0; c < most.size(); ++c) {
    const Cell& cell = groups.cells()[c];
    const std::vector<double> r = residualsOf(cell, nominal);
    const Split now = split(r);
    Split fallen = now;
    const double share = std::min(1.0, cell.noise / likeliestScale(now.about, cell.noise));
    for (double& of : fallen.about) of *= share;
    fallen.mean = std::clamp(now.mean, -cell.noise, cell.noise);
    most[c] = std::max(
        0.0, stretchDensity(fallen, cell.noise, shares[c]) - stretchDensity(now, cell.noise, shares[c]));
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
  std::erase_if(possible, [&](const Cause& cause) {
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
    return best <= std::log(static_cast<double>(kinds));
  });
  replayStarts(possible, nominal, progress);
}

void CandidateScreening::replayStarts(const std::vector<Cause>& worth, const Residuals& nominal,
                                      const std::function<void(double)>& progress) {
  const Groups& groups = replayer.groups();
  for (std::size_t i = 0; i < worth.size(); ++i) {
    if (progress) progress(static_cast<double>(i) / static_cast<double>(worth.size()));
    Cause cause = worth[i];
    for (const double value : cause.effect->starts) {
      cause.value = value * cause.effect->scaleAt(replayer.mechanism(), cause.place);
      const Explanation alone = withLogStrengths(replayer.mechanism(), {cause}, logStrengths({cause}));
      const Residuals with = replayer.residuals(alone, looked);
      Start start{alone.front(), {}};
      for (std::size_t c = 0; c < groups.cells().size(); ++c) {
        const Cell& cell = groups.cells()[c];
        if (!looked[cell.trial] || with[cell.trial][cell.signal] == nominal[cell.trial][cell.signal])
          continue;
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

double CandidateScreening::gainOf(const Start& start, const std::vector<Left>& left, const Shares& shares,
                                  double& share) const {
  double product = 0, squares = 0;
  const auto add = [&](double w, double r, double d) {
    product += w * r * d;
    squares += w * d * d;
  };
  for (const Change& change : start.changes) {
    const Left& of = left[change.cell];
    double mean = 0, n = 0;
    for (std::size_t k = 0; k < std::min(of.values.size(), change.values.size()); ++k)
      if (std::isfinite(of.values[k])) mean += change.values[k], ++n;
    if (n == 0) continue;
    mean /= n;
    const double each = shares[change.cell] * static_cast<double>(thinning(cellOf(change.cell)));
    for (std::size_t k = 0; k < std::min(of.values.size(), change.values.size()); ++k)
      if (const double r = of.parts.about[k]; std::isfinite(r))
        add(each * weightOf(r, of.scale), r, change.values[k] - mean);
    add(weightOf(of.parts.mean, std::max(cellOf(change.cell).noise, std::abs(of.parts.mean))), of.parts.mean,
        mean);
  }
  if (!(product > 0) || !(squares > 0)) return 0;
  share = std::clamp(product / squares, 1 / mostFactor, mostFactor);
  double gain = 0;
  for (const Change& change : start.changes) {
    const Cell& cell = cellOf(change.cell);
    std::vector<double> r = left[change.cell].values;
    for (std::size_t k = 0; k < std::min(r.size(), change.values.size()); ++k)
      r[k] -= share * static_cast<double>(change.values[k]);
    gain += stretchDensity(split(r), cell.noise, shares[change.cell] * static_cast<double>(thinning(cell))) -
            left[change.cell].density;
  }
  return gain;
}

std::vector<Proposal> CandidateScreening::propose(const Explanation& base, const Shares& shares,
                                                  std::size_t most) const {
  const Groups& groups = replayer.groups();
  const Residuals residuals = replayer.residuals(base);
  std::vector<Left> left;
  for (std::size_t c = 0; c < groups.cells().size(); ++c) {
    const Cell& cell = groups.cells()[c];
    Left& of = left.emplace_back();
    of.values = thinned(residualsOf(cell, residuals), thinning(cell));
    of.parts = split(of.values);
    of.scale = likeliestScale(of.parts.about, cell.noise);
    of.density = stretchDensity(of.parts, cell.noise, shares[c] * static_cast<double>(thinning(cell)));
  }
  std::vector<Proposal> proposals;
  for (const Start& start : starts) {
    if (std::ranges::any_of(base, [&](const Cause& cause) { return cause.sameKind(start.cause); })) continue;
    double share = 1;
    const double gain = gainOf(start, left, shares, share);
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
