#include "gap/inference/SettingMask.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "gap/inference/Density.h"

namespace plumbline::gap {

namespace {

/// Log density of what a hypothesis leaves in each recording.
std::map<std::string, double> densityPerRecording(const Replayer& replayer, const Shares& shares,
                                                  const Explanation& causes) {
  const Groups& groups = replayer.groups();
  const Residuals residuals = replayer.residuals(causes);
  std::map<std::string, double> sums;
  for (std::size_t c = 0; c < groups.cells().size(); ++c) {
    const Cell& cell = groups.cells()[c];
    sums[groups.trials()[cell.trial].recording] += densityOf(cell, residuals, shares[c]);
  }
  return sums;
}

}  // namespace

std::vector<std::string> recordingsOf(const Groups& groups) {
  std::vector<std::string> recordings;
  for (std::size_t t = 0; t < groups.trials().size(); ++t) {
    const std::string& recording = groups.trials()[t].recording;
    if (groups.holds(t) && std::ranges::find(recordings, recording) == recordings.end())
      recordings.push_back(recording);
  }
  return recordings;
}

double priceOfMasks(const Explanation& causes, const std::vector<std::string>& recordings) {
  const auto n = static_cast<double>(recordings.size());
  double price = 0;
  for (const Cause& cause : causes) {
    const auto k = static_cast<double>(inactiveAmong(cause, recordings));
    if (k > 0) price += std::log(n + 1) + std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1);
  }
  return price;
}

Explanation expectedElsewhere(Explanation causes, const std::vector<std::string>& recordings) {
  std::erase_if(causes, [&](const Cause& cause) { return !isExpectedElsewhere(cause, recordings); });
  for (Cause& cause : causes) cause.inactiveIn.clear();
  return causes;
}

Explanation withLikeliestMasks(const Replayer& replayer, Explanation causes) {
  const std::vector<std::string> recordings = recordingsOf(replayer.groups());
  for (std::size_t i = 0; i < causes.size() && recordings.size() > 1; ++i) {
    if (!causes[i].effect->setting) continue;
    const Shares shares = sharesOf(replayer.groups(), replayer.residuals(causes));
    Explanation everywhere = causes;
    everywhere[i].inactiveIn.clear();
    const auto with = densityPerRecording(replayer, shares, everywhere),
               less = densityPerRecording(replayer, shares, without(causes, i));
    const auto worth = [&](const Explanation& of) {
      double sum = -priceOfMasks(of, recordings);
      for (const auto& [recording, density] : with)
        sum += std::ranges::find(of[i].inactiveIn, recording) == of[i].inactiveIn.end() ? density
                                                                                        : less.at(recording);
      return sum;
    };
    Explanation masked = everywhere;
    for (const std::string& recording : recordings)
      if (less.at(recording) > with.at(recording)) masked[i].inactiveIn.push_back(recording);
    // A cause that is inactive everywhere is none; the search drops those by itself.
    if (masked[i].inactiveIn.size() == recordings.size()) continue;
    if (worth(masked) > worth(causes)) causes = std::move(masked);
    if (worth(everywhere) > worth(causes)) causes = std::move(everywhere);
  }
  return causes;
}

}  // namespace plumbline::gap
