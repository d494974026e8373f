#pragma once
#include <cstddef>
#include <vector>

#include "field/FieldSize.h"
#include "tactics/FieldValue.h"

namespace plumbline {

/// Learns a FieldValue from the motion of balls in games: a Markov chain over the points of a grid with a
/// goal at each end. A step of a fixed time is counted for both teams, so the values of both add up to 0. If
/// there is little data, random steps are added: `priorSteps` at each point, normally distributed by
/// `priorDeviation` about a drift with the team that has the ball. In front of a goal they end in it. The
/// values are the chain's probabilities of absorption (Kemeny and Snell, Finite Markov Chains, theorem
/// 3.3.7), as in the analysis of people's football (Rudd 2011, "A framework for tactical analysis and
/// individual offensive production assessment").
class FieldValueLearner {
public:
  struct Options {
    double goalX = FieldSize().length / 2;             ///< of the goal's line [m]
    double goalHalfWidth = FieldSize().goalWidth / 2;  ///< [m]
    double priorSteps = 3;
    double priorDeviation = 2;  ///< [m]
    double priorDrift = 1;      ///< of a ball that is one team's, towards the other's goal [m]
  };

  FieldValueLearner(FieldGrid grid, const Options& options);
  /// From one state to another.
  void addStep(const BallState& from, const BallState& to);
  /// From a state to a goal, ours or theirs.
  void addGoal(const BallState& from, bool ours);
  std::size_t steps() const { return steps_; }
  std::size_t goals() const { return goals_; }
  FieldValue learn() const;

private:
  void add(const BallState& from, const BallState& to);
  double& count(std::size_t from, std::size_t to) { return counts_[from * (grid_.size() + 2) + to]; }
  void addPrior();

  FieldGrid grid_;
  Options options_;
  std::vector<double> counts_;  ///< rows: from; columns: to, then our goal and theirs
  std::size_t steps_ = 0, goals_ = 0;
};

}  // namespace plumbline
