#pragma once
#include <cstddef>
#include <vector>

#include "tactics/FieldValue.h"

namespace plumbline {

/// Learns a FieldValue from what balls did in games: a Markov chain over the points of a grid with a goal at
/// each end. A step of a fixed time is seen from both teams, so that the values of both add up to 0. Where
/// little was seen a ball that rolls to and fro is assumed (`priorSteps` of each point, normally distributed
/// by `priorDeviation` about a drift with the team that has it), which a goal takes in before its mouth. The
/// values are the chain's probabilities of absorption (Kemeny and Snell, Finite Markov Chains,
/// theorem 3.3.7), as in the analysis of people's football (Rudd 2011, "A framework for tactical analysis and
/// individual offensive production assessment").
class FieldValueLearner {
public:
  struct Options {
    double goalX = 15;            ///< of the goal's line [m]
    double goalHalfWidth = 1.05;  ///< [m]
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
