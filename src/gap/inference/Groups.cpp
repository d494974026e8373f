#include "gap/inference/Groups.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "gap/diagnosis/Noise.h"
#include "gap/replay/CurrentSide.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t numStretches = 4;
constexpr double enoughSeconds = 30;  // of recordings, to separate causes

std::vector<Trial> withCurrentSides(std::vector<Trial> trials) {
  findCurrentSide(trials);
  return trials;
}

}  // namespace

Groups::Groups(std::vector<Trial> trials, const std::vector<Prediction>& predicted)
    : all_(std::make_shared<const std::vector<Trial>>(withCurrentSides(std::move(trials)))),
      channels_(std::make_shared<const std::vector<std::vector<ChannelUse>>>(channelUses(*all_, predicted))) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < all_->size(); ++t) {
    std::size_t recording = count;
    for (std::size_t other = 0; other < t && recording == count; ++other)
      if ((*all_)[other].recording == (*all_)[t].recording || isRepeat((*all_)[other], (*all_)[t]))
        recording = recordingOf_[other];
    count = std::max(count, recording + 1);
    recordingOf_.push_back(recording);
  }
  in_.assign(count, 1);
  std::vector<std::vector<std::size_t>> bounds;
  for (const Trial& trial : *all_) bounds.push_back(stretchesOf(trial, numStretches));
  bounds_ = std::make_shared<const std::vector<std::vector<std::size_t>>>(std::move(bounds));
  number();
}

Groups Groups::without(std::size_t group) const {
  Groups other = *this;
  std::size_t seen = 0;
  for (char& flag : other.in_)
    if (flag && seen++ == group) {
      flag = 0;
      break;
    }
  other.number();
  return other;
}

Groups Groups::withFixedBaseAsOne() const {
  Groups other = *this;
  std::optional<std::size_t> first;
  for (std::size_t t = 0; t < all_->size(); ++t) {
    if ((*all_)[t].freeBase) continue;
    if (!first) first = recordingOf_[t];
    if (recordingOf_[t] != *first) other.in_[recordingOf_[t]] = 0;
    other.recordingOf_[t] = *first;
  }
  other.number();
  return other;
}

void Groups::number() {
  std::vector<char> trialIn(all_->size(), 1);
  if (!stretches_) {
    for (std::size_t t = 0; t < all_->size(); ++t) trialIn[t] = in_[recordingOf_[t]];
    if (std::ranges::count(in_, 1) == 1) {
      stretches_ = true;
      in_.assign(numStretches, 1);
      for (std::size_t t = 0; t < all_->size(); ++t) recordingOf_[t] = trialIn[t] ? 0 : 1;
    }
  } else {
    for (std::size_t t = 0; t < all_->size(); ++t) trialIn[t] = recordingOf_[t] == 0;
  }
  groups_ = 0;
  scored_.clear();
  numberOf_.resize(in_.size());
  for (std::size_t i = 0; i < in_.size(); ++i) numberOf_[i] = in_[i] ? groups_++ : 0;
  members_.assign(groups_, std::vector<char>(all_->size(), 0));
  for (std::size_t t = 0; t < all_->size(); ++t) {
    const Trial& trial = (*all_)[t];
    const std::vector<std::size_t>& bounds = (*bounds_)[t];
    const std::size_t parts = stretches_ ? numStretches : 1;
    for (std::size_t s = 0; s < trial.signals.size() && trialIn[t]; ++s) {
      const ChannelUse& use = (*channels_)[t][s];
      for (std::size_t part = 0; part < parts && use.used; ++part) {
        if (stretches_ && !in_[part]) continue;
        const Cell cell{numberOf_[stretches_ ? part : recordingOf_[t]],
                        t,
                        s,
                        bounds[part],
                        stretches_ ? bounds[part + 1] : bounds.back(),
                        use.noise * std::hypot(1, enginesDiffer)};
        bool any = false;
        for (std::size_t k = cell.from; k < cell.to && !any; ++k)
          any = std::isfinite(trial.signals[s].values[k]);
        if (!any) continue;
        scored_.push_back(cell);
        members_[cell.group][t] = 1;
      }
    }
  }
}

std::vector<char> enoughTrials(const Groups& groups) {
  const std::vector<Trial>& trials = groups.trials();
  std::vector<char> taken(trials.size(), 0);
  std::vector<std::size_t> segments(groups.count(), 0);
  std::vector<std::pair<std::size_t, std::size_t>> order;  // how many of its group came before, trial
  for (std::size_t t = 0; t < trials.size(); ++t) {
    std::size_t group = 0;
    while (group < groups.count() && !groups.holds(group, t)) ++group;
    if (group < groups.count()) order.emplace_back(segments[group]++, t);
  }
  std::ranges::sort(order);
  double seconds = 0;
  for (const auto& [segment, t] : order) {
    if (segment > 0 && seconds > enoughSeconds) break;
    taken[t] = 1;
    seconds += trials[t].time.back() - trials[t].time.front();
  }
  return taken;
}

bool Groups::holds(std::size_t trial) const {
  return std::ranges::any_of(members_, [&](const std::vector<char>& of) { return of[trial] != 0; });
}

std::size_t Groups::groupOf(std::size_t trial, std::size_t cycle) const {
  if (!stretches_) return numberOf_[recordingOf_[trial]];
  const std::vector<std::size_t>& bounds = (*bounds_)[trial];
  const auto next = std::upper_bound(bounds.begin() + 1, bounds.end() - 1, cycle);
  return numberOf_[static_cast<std::size_t>(next - bounds.begin()) - 1];
}

}  // namespace plumbline::gap
