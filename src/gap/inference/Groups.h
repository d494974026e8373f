#pragma once
#include <memory>
#include <vector>

#include "gap/inference/Channels.h"
#include "gap/inference/Stretches.h"
#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// Two engines that integrate one model differ by this share of a channel's noise. What changes every channel
/// by less says how the replay is computed, and nothing about the robot.
constexpr double enginesDiffer = 0.5;

/// A stretch of one channel of one trial: the smallest thing that is scored by itself.
struct Cell {
  std::size_t group = 0, trial = 0, signal = 0;
  std::size_t from = 0, to = 0;  ///< cycles [from, to)
  double noise = 0;              ///< least scale of its residuals
};

/// Recordings in groups of which each is left out by itself: segments and repeats of one recording are one
/// group. Where that makes one group alone, four stretches (stretchesOf) serve as groups, and the answer
/// says so.
class Groups {
public:
  /// predicted: what a model predicts of each trial, for the noise (channelUses); empty: of none.
  explicit Groups(std::vector<Trial> trials, const std::vector<Prediction>& predicted = {});

  /// The same without one group: the others, renumbered; one that is left alone is cut into stretches.
  Groups without(std::size_t group) const;
  /// All, the recordings with a fixed base as one group.
  Groups withFixedBaseAsOne() const;

  const std::vector<Trial>& trials() const { return *all_; }
  const std::vector<std::vector<ChannelUse>>& uses() const { return *channels_; }
  const std::vector<Cell>& cells() const { return scored_; }
  std::size_t count() const { return groups_; }
  bool stretchesOfOne() const { return stretches_; }
  /// Whether a trial has anything in a group, or in any.
  bool holds(std::size_t group, std::size_t trial) const { return members_[group][trial] != 0; }
  bool holds(std::size_t trial) const;
  /// The number of the group that a trial's cycle is in. Only of trials whose group was not left out.
  std::size_t groupOf(std::size_t trial, std::size_t cycle) const;

private:
  Groups() = default;
  void number();

  std::shared_ptr<const std::vector<Trial>> all_;
  std::shared_ptr<const std::vector<std::vector<ChannelUse>>> channels_;
  std::shared_ptr<const std::vector<std::vector<std::size_t>>> bounds_;  ///< per trial: of its stretches
  std::vector<std::size_t> recordingOf_;  ///< per trial: recording with its repeats
  std::vector<char> in_;                  ///< per recording, or per stretch of the only one: still there
  bool stretches_ = false;
  std::size_t groups_ = 0;
  std::vector<std::size_t> numberOf_;  ///< per recording or stretch that is still there
  std::vector<Cell> scored_;
  std::vector<std::vector<char>> members_;  ///< per group and trial
};

/// Samples of a cell that are enough for a search.
inline constexpr std::size_t enoughSamples = 250;

/// Flags of trials that are enough for a search: segments and repeats of recordings, one of each after the
/// other, until they are 30 s long; at least one trial of each group.
std::vector<char> enoughTrials(const Groups& groups);

}  // namespace plumbline::gap
