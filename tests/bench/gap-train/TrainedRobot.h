#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "gap/blind/BlindCase.h"
#include "gap/diagnosis/Explanation.h"
#include "training/WalkTrial.h"
#include "walking/parameters/WalkGaits.h"

namespace plumbline::bench {

/// Robots are drawn until the walk trained without loses a share of its speed between these.
inline constexpr double leastLoss = 0.1, mostLoss = 0.9;

struct TrainSetup {
  std::uint64_t seed = 1, jobs = 1, generations = 25, population = 12, tries = 6, seconds = 6, measured = 24;
  std::string folder;
};

/// One robot from its recording to its two walks.
struct TrainedRobot {
  gap::BlindCase truth;
  std::string verdict;
  std::vector<gap::BlindEffect> found;  ///< what was trained with
  walking::TrialResult without, with;   ///< on the true robot
  std::vector<double> differences;      ///< of speed, per try [m/s]
};

/// What all robots share: the walk that the search finds on the nominal model.
class TrainBench {
public:
  explicit TrainBench(const TrainSetup& setup);
  TrainedRobot robot(std::size_t turn) const;
  double speedOnNominal() const { return onNominal_; }

private:
  /// Draws until the nominal walk loses enough.
  gap::BlindCase draw(std::size_t turn) const;
  void record(const std::string& folder) const;
  /// Searches a walk on the model with these effects; does nothing where that was done.
  void train(const std::string& effects, const std::string& output) const;
  /// Each try on the true robot: its mean speed [m/s], 0 from a fall on, and falls.
  std::vector<walking::TrialResult> measure(const walking::WalkGaits& walk, const gap::Explanation& effects,
                                            std::uint64_t tries) const;

  const TrainSetup setup_;
  const Mechanism mechanism_;
  walking::WalkGaits nominalWalk_;
  double onNominal_ = 0;
};

}  // namespace plumbline::bench
