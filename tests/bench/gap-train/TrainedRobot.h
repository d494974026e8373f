#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "gap/blind/BlindCase.h"
#include "gap/diagnosis/Explanation.h"
#include "training/WalkTrial.h"
#include "walking/parameters/WalkGaits.h"

namespace plumbline::bench {

/// Robots are drawn until the walk trained without loses a share of its speed between these: the least surely
/// (95 %).
inline constexpr double leastLoss = 0.1, mostLoss = 0.9;

struct TrainSetup {
  std::uint64_t seed = 1, jobs = 1, generations = 25, population = 12, tries = 6, seconds = 6, measured = 100;
  std::uint64_t startGenerations = 25;  ///< of the search from which all others begin
  std::string engine = "mujoco";  ///< that the robots are in; searches for walks and the model use Bullet
  std::string folder;
};

double mean(const std::vector<double>& values);

/// What a search begins with.
struct TrainStart {
  std::string effects;  ///< file of what the model has; empty: nothing
  std::string from;     ///< folder of a walking.yaml; empty: the robot's own walk
};

/// One robot from its recording to its two walks.
struct TrainedRobot {
  gap::BlindCase truth;
  std::string verdict;
  std::vector<gap::BlindEffect> found;      ///< what was trained with
  training::WalkTrialResult without, with;  ///< on the true robot
  std::vector<double> differences;          ///< of speed, per try [m/s]
};

/// What all robots share: a walk searched on the nominal model. Searched once more on that model it is the
/// walk without; searched as long on the model with what was found it is a robot's walk with.
class TrainBench {
public:
  explicit TrainBench(const TrainSetup& setup);
  TrainedRobot robot(std::size_t turn) const;
  /// Of the walk without, on the nominal robot: in the robots' engine, and in that of the searches [m/s].
  double speedOnNominal() const { return onNominal_; }
  double speedOnModel() const { return onModel_; }

private:
  /// How much the nominal walk loses by effects, as leastLoss and mostLoss count it.
  enum class Loss { tooLittle, enough, tooMuch };
  Loss lossWith(const gap::Explanation& effects) const;
  /// Draws until the nominal walk loses enough.
  gap::BlindCase draw(std::size_t turn) const;
  void record(const std::string& folder) const;
  /// Searches a walk; does nothing where that was done.
  void train(const TrainStart& start, const std::string& output, std::uint64_t generations) const;
  /// Each try on the robot with these effects, numbered from `first` (its seed): its mean speed [m/s], 0
  /// from a fall on, and falls. In the robots' engine.
  std::vector<training::WalkTrialResult> measure(const walking::WalkGaits& walk,
                                                 const gap::Explanation& effects, std::uint64_t tries,
                                                 std::uint64_t first = 0) const {
    return measureIn(setup_.engine, walk, effects, tries, first);
  }
  std::vector<training::WalkTrialResult> measureIn(const std::string& engine, const walking::WalkGaits& walk,
                                                   const gap::Explanation& effects, std::uint64_t tries,
                                                   std::uint64_t first) const;

  const TrainSetup setup_;
  const Mechanism mechanism_;
  std::string start_;  ///< folder of the walk that the second searches begin with
  walking::WalkGaits nominalWalk_;
  double onNominal_ = 0, onModel_ = 0;
  std::vector<training::WalkTrialResult>
      drawnOnNominal_;  ///< tries that robots to be drawn are compared with
};

}  // namespace plumbline::bench
