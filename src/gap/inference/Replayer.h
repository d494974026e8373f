#pragma once
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "gap/inference/Groups.h"
#include "gap/inference/ResidualSeries.h"
#include "gap/replay/Replay.h"

namespace plumbline::gap {

/// Measured less predicted, per cycle; NaN where nothing was measured. Null: not predicted.
using Series = std::shared_ptr<const ResidualSeries>;
/// Per trial and signal.
using Residuals = std::vector<std::vector<Series>>;

/// A pure function from a hypothesis (causes with their values) to residuals. Chains of a fixed base do not
/// feel each other: each is replayed by itself, and once for all hypotheses that are alike in what it feels.
/// A constant lead of a channel within 0.2 ms, as two integrators differ by, is taken off.
class Replayer {
public:
  /// base: causes that the robot has with every hypothesis.
  Replayer(const Mechanism& robot, const Groups& groups, int jobs, const ReplayOptions& accuracy = {},
           Explanation base = {});

  /// The same for other groups of the same trials (Groups::without): what was replayed for one serves the
  /// other.
  Replayer(const Replayer& whole, const Groups& groups) : Replayer(whole, groups, whole.fixed_) {}
  Replayer(const Replayer& whole, const Groups& groups, Explanation base);

  /// wanted: one flag per trial; empty: all that are in a group. Trials not wanted stay empty.
  Residuals residuals(const Explanation& hypothesis, const std::vector<char>& wanted = {}) const;
  /// Joints of the chains that feel a cause where the base is fixed.
  const std::vector<std::vector<int>>& chains() const { return chainJoints_; }
  bool feels(std::size_t chain, const Cause& cause) const;

  const Mechanism& mechanism() const { return robot_; }
  const Groups& groups() const { return data_; }
  const Explanation& base() const { return fixed_; }
  int jobs() const { return threads_; }
  /// So far, with those for other groups.
  std::size_t numReplays() const { return memory_->replays; }
  /// The same with those that were in memory: how many, whatever came before.
  std::size_t numAsked() const { return memory_->asked; }

private:
  using Played = std::shared_ptr<const std::vector<std::pair<std::size_t, Series>>>;
  struct Task {
    std::size_t trial, chain;
    std::string key;
    Played played;
  };
  Played play(std::size_t trial, std::size_t chain, const Explanation& causes) const;
  std::string keyOf(std::size_t trial, std::size_t chain, const Explanation& causes) const;
  bool hasBodySignals(std::size_t trial) const;
  std::size_t chainsOf(std::size_t trial) const;

  const Mechanism& robot_;
  const Groups& data_;
  int threads_;
  ReplayOptions accuracy_;
  Explanation fixed_;
  std::vector<std::vector<int>> chainJoints_;
  /// Per trial and signal: the measured slope in each cycle.
  std::shared_ptr<const std::vector<std::vector<std::vector<double>>>> rates_;
  struct Memory {
    std::mutex mutex;
    std::map<std::string, std::pair<Played, std::list<std::string>::iterator>> cache;
    std::list<std::string> recent;  ///< keys, the last used first
    std::size_t kept = 0, replays = 0, asked = 0;
  };
  std::shared_ptr<Memory> memory_ = std::make_shared<Memory>();
};

}  // namespace plumbline::gap
