#include "gap/inference/Groups.h"

#include <algorithm>
#include <cmath>

#include "gap/diagnosis/Noise.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t numStretches = 4;
constexpr double startSeconds = 0.3;

}  // namespace

std::size_t firstScored(const Trial& trial) {
  return static_cast<std::size_t>(std::ranges::lower_bound(trial.time, trial.time.front() + startSeconds) -
                                  trial.time.begin());
}

Groups::Groups(std::vector<Trial> trials) : all(std::move(trials)), channels(channelUses(all)) {
  for (std::size_t t = 0; t < all.size(); ++t) {
    std::size_t group = groups;
    for (std::size_t other = 0; other < t && group == groups; ++other)
      if (all[other].recording == all[t].recording || isRepeat(all[other], all[t]))
        group = groupOfTrial[other];
    groups = std::max(groups, group + 1);
    groupOfTrial.push_back(group);
  }
  if (groups == 1) {
    stretches = true;
    groups = numStretches;
  }
  for (std::size_t t = 0; t < all.size(); ++t)
    for (std::size_t s = 0; s < all[t].signals.size(); ++s) {
      if (!channels[t][s].used) continue;
      const std::size_t cycles = all[t].cycles(), first = firstScored(all[t]);
      const std::size_t parts = stretches ? numStretches : 1;
      for (std::size_t part = 0; part < parts; ++part) {
        const Cell cell{stretches ? part : groupOfTrial[t],
                        t,
                        s,
                        std::max(first, part * cycles / parts),
                        (part + 1) * cycles / parts,
                        channels[t][s].noise};
        const auto& values = all[t].signals[s].values;
        bool any = false;
        for (std::size_t k = cell.from; k < cell.to && !any; ++k) any = std::isfinite(values[k]);
        if (any) scored.push_back(cell);
      }
    }
}

bool Groups::holds(std::size_t group, std::size_t trial) const {
  return stretches || groupOfTrial[trial] == group;
}

std::size_t Groups::groupOf(std::size_t trial, std::size_t cycle) const {
  if (!stretches) return groupOfTrial[trial];
  return std::min(numStretches - 1, cycle * numStretches / std::max<std::size_t>(1, all[trial].cycles()));
}

}  // namespace plumbline::gap
