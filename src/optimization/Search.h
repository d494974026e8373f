#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "optimization/Optimizer.h"

namespace plumbline {

/// A piece of work: runs of one candidate.
struct Trial {
  std::int64_t number = 0;      ///< of the piece; the same whoever asks in whatever order
  std::int64_t candidate = 0;   ///< counted over the whole search
  std::int64_t generation = 0;  ///< from 0
  Eigen::VectorXd parameters;
  std::vector<std::uint64_t> seeds;  ///< one per run
};

/// Number of runs of a candidate with noisy costs. All get `first` runs; the better half of a generation,
/// towards which an optimiser moves, gets more, up to `best` in all. The cost is the mean.
struct Averaging {
  int first = 1, best = 1;
  bool sameSeeds = true;  ///< for all candidates of a generation: what differs is then the candidates' own
};

/// What happened to a result.
enum class ResultStatus { taken, again, unknown };

/// Any optimiser, with ask and tell for one candidate at a time in any order. The candidates' numbers and
/// what is learnt depend only on the results and not on their order: results wait until the whole generation
/// is complete. A result that is not a number counts as worse than all others; a missing one can be given up.
/// Both are counted.
class Search {
public:
  static constexpr int mostRuns = 10000;

  /// `seed` makes the seeds of the runs. Throws std::invalid_argument for runs out of 1 .. 10000.
  Search(std::unique_ptr<Optimizer> optimizer, const Averaging& averaging, std::uint64_t seed);

  /// Something to evaluate that was not handed out yet; nothing while all that may be is handed out, or when
  /// the search is over.
  std::optional<Trial> next();
  /// Costs of the trial's runs. Throws std::invalid_argument for another number of them.
  ResultStatus tell(std::int64_t number, std::span<const double> costs);
  /// Gives a trial up, as if no run had a number.
  ResultStatus giveUp(std::int64_t number);
  /// The trial of that number while it is open.
  std::optional<Trial> find(std::int64_t number) const;

  bool isDone() const { return optimizer_->isDone(); }
  const Optimizer& optimizer() const { return *optimizer_; }
  std::int64_t notNumbers() const { return notNumbers_; }  ///< runs
  std::int64_t givenUp() const { return givenUp_; }        ///< trials
  std::int64_t trials() const { return trials_; }          ///< evaluated
  std::int64_t runs() const { return runs_; }              ///< evaluated

private:
  struct Candidate {
    double sum = 0;
    int runs = 0;
    bool asked[2] = {}, evaluated[2] = {}, wanted = false;  ///< wanted: in the second round
  };
  struct Generation {
    std::vector<Candidate> candidates;
    bool second = false;  ///< the second round has begun
  };
  struct Place {
    std::size_t generation, candidate;
    int round;
  };

  void open();
  std::optional<Place> placeOf(std::int64_t number) const;
  Trial trialAt(const Place& place) const;
  int runsOf(int round) const;
  void beginSecond(Generation& generation) const;
  bool complete(const Generation& generation) const;
  ResultStatus take(std::int64_t number, std::span<const double> costs);
  void advance();

  std::unique_ptr<Optimizer> optimizer_;
  Averaging averaging_;
  std::uint64_t seed_;
  std::deque<Generation> generations_;
  std::int64_t firstGeneration_ = 0;
  std::int64_t notNumbers_ = 0, givenUp_ = 0, trials_ = 0, runs_ = 0;
};

}  // namespace plumbline
