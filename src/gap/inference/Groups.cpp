#include "gap/inference/Groups.h"

#include <algorithm>
#include <cmath>

#include "gap/diagnosis/Noise.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t numStretches = 4;
constexpr double startSeconds = 0.3;
constexpr double engines =
    0.5;  // of a channel's noise: what two engines differ by with one and the same model

}  // namespace

std::size_t firstScored(const Trial& trial) {
  return static_cast<std::size_t>(std::ranges::lower_bound(trial.time, trial.time.front() + startSeconds) -
                                  trial.time.begin());
}

Groups::Groups(std::vector<Trial> trials)
    : all(std::make_shared<const std::vector<Trial>>(std::move(trials))),
      channels(std::make_shared<const std::vector<std::vector<ChannelUse>>>(channelUses(*all))) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < all->size(); ++t) {
    std::size_t recording = count;
    for (std::size_t other = 0; other < t && recording == count; ++other)
      if ((*all)[other].recording == (*all)[t].recording || isRepeat((*all)[other], (*all)[t]))
        recording = recordingOf[other];
    count = std::max(count, recording + 1);
    recordingOf.push_back(recording);
  }
  in.assign(count, 1);
  number();
}

Groups Groups::without(std::size_t group) const {
  Groups other;
  other.all = all;
  other.channels = channels;
  other.recordingOf = recordingOf;
  other.in = in;
  other.stretches = stretches;
  std::size_t seen = 0;
  for (char& flag : other.in)
    if (flag && seen++ == group) {
      flag = 0;
      break;
    }
  other.number();
  return other;
}

void Groups::number() {
  std::vector<char> trialIn(all->size(), 1);
  if (!stretches) {
    for (std::size_t t = 0; t < all->size(); ++t) trialIn[t] = in[recordingOf[t]];
    if (std::ranges::count(in, 1) == 1) {
      stretches = true;
      in.assign(numStretches, 1);
      for (std::size_t t = 0; t < all->size(); ++t) recordingOf[t] = trialIn[t] ? 0 : 1;
    }
  } else {
    for (std::size_t t = 0; t < all->size(); ++t) trialIn[t] = recordingOf[t] == 0;
  }
  groups = 0;
  std::vector<std::size_t> numberOf(in.size());
  for (std::size_t i = 0; i < in.size(); ++i) numberOf[i] = in[i] ? groups++ : 0;
  held.assign(groups, std::vector<char>(all->size(), 0));
  for (std::size_t t = 0; t < all->size(); ++t) {
    const Trial& trial = (*all)[t];
    const std::size_t cycles = trial.cycles(), first = firstScored(trial);
    const std::size_t parts = stretches ? numStretches : 1;
    for (std::size_t s = 0; s < trial.signals.size() && trialIn[t]; ++s) {
      const ChannelUse& use = (*channels)[t][s];
      for (std::size_t part = 0; part < parts && use.used; ++part) {
        if (stretches && !in[part]) continue;
        const Cell cell{numberOf[stretches ? part : recordingOf[t]],
                        t,
                        s,
                        std::max(first, part * cycles / parts),
                        (part + 1) * cycles / parts,
                        use.noise * std::hypot(1, engines)};
        bool any = false;
        for (std::size_t k = cell.from; k < cell.to && !any; ++k)
          any = std::isfinite(trial.signals[s].values[k]);
        if (!any) continue;
        scored.push_back(cell);
        held[cell.group][t] = 1;
      }
    }
  }
}

bool Groups::holds(std::size_t trial) const {
  return std::ranges::any_of(held, [&](const std::vector<char>& of) { return of[trial] != 0; });
}

std::size_t Groups::groupOf(std::size_t trial, std::size_t cycle) const {
  if (!stretches) return recordingOf[trial];
  return std::min(numStretches - 1, cycle * numStretches / std::max<std::size_t>(1, (*all)[trial].cycles()));
}

}  // namespace plumbline::gap
