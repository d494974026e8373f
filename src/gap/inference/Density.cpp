#include "gap/inference/Density.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace plumbline::gap {

std::vector<double> residualsOf(const Cell& cell, const Residuals& residuals) {
  const Series& series = residuals[cell.trial][cell.signal];
  if (!series) return {};
  return series->stretch(cell.from, cell.to);
}

Shares sharesOf(const Groups& groups, const Residuals& residuals) {
  const std::vector<Cell>& cells = groups.cells();
  Shares shares;
  // Per trial, joint and first cycle: the position's share.
  std::map<std::tuple<std::size_t, int, std::size_t>, double> ofPositions;
  for (const Cell& cell : cells) {
    const Series& series = residuals[cell.trial][cell.signal];
    shares.push_back(series ? 1 / series->correlationOf(cell.from, cell.to) : 1);
    const Signal& signal = groups.trials()[cell.trial].signals[cell.signal];
    if (signal.kind == SignalKind::position)
      ofPositions[{cell.trial, signal.joint, cell.from}] = shares.back();
  }
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const Signal& signal = groups.trials()[cells[c].trial].signals[cells[c].signal];
    if (!isEffort(signal.kind)) continue;
    if (const auto at = ofPositions.find({cells[c].trial, signal.joint, cells[c].from});
        at != ofPositions.end())
      shares[c] = std::min(shares[c], at->second);
  }
  return shares;
}

bool isPosition(const Groups& groups, const Cell& cell) {
  return groups.trials()[cell.trial].signals[cell.signal].kind == SignalKind::position;
}

double squaresOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double r : values)
    if (std::isfinite(r)) sum += r * r;
  return sum;
}

double densityOf(const Cell& cell, const Residuals& residuals, double share) {
  const Series& series = residuals[cell.trial][cell.signal];
  return series ? series->fitOf(cell.from, cell.to, cell.noise).density(share) : 0;
}

std::vector<double> densities(const Groups& groups, const Residuals& residuals, const Shares& shares,
                              const std::vector<char>& wantedGroups) {
  std::vector<double> sums(groups.count(), 0.0);
  for (std::size_t c = 0; c < groups.cells().size(); ++c) {
    const Cell& cell = groups.cells()[c];
    if (wantedGroups.empty() || wantedGroups[cell.group])
      sums[cell.group] += densityOf(cell, residuals, shares[c]);
  }
  return sums;
}

double densityOn(const Replayer& replayer, const Shares& shares, const Explanation& causes,
                 const std::vector<char>& wantedGroups) {
  const Groups& groups = replayer.groups();
  const std::vector<double> of =
      densities(groups, replayer.residuals(causes, trialsOf(groups, wantedGroups)), shares, wantedGroups);
  return std::accumulate(of.begin(), of.end(), 0.0);
}

std::vector<char> trialsOf(const Groups& groups, const std::vector<char>& wantedGroups) {
  std::vector<char> wanted(groups.trials().size(), 0);
  for (std::size_t t = 0; t < wanted.size(); ++t)
    for (std::size_t g = 0; g < groups.count(); ++g)
      if ((wantedGroups.empty() || wantedGroups[g]) && groups.holds(g, t)) wanted[t] = 1;
  return wanted;
}

}  // namespace plumbline::gap
