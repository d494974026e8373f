#pragma once
#include <memory>

#include "optimization/Cmaes.h"

namespace plumbline {

/// CMA-ES that restarts after it has converged, until maxEvaluations, maxGenerations (of all runs together),
/// targetCost or `restarts`. A restart begins at a random place. That is uniform in finite bounds, else
/// normal around the start with a deviation that doubles with the population, as does the restart's own.
/// Without bounds, the first deviation may be too small for the distances between minima. IPOP (Auger and
/// Hansen, CEC 2005): each restart has twice the population. BIPOP (Hansen, GECCO workshop 2009): the larger
/// ones alternate with small ones of random size and smaller sigma, whichever kind has used fewer evaluations
/// being next.
class CmaesRestarts : public Optimizer {
public:
  enum class Kind { ipop, bipop };
  /// options.population is the first run's; options.stop applies to each run, its limits to all together.
  CmaesRestarts(SearchSpace space, CmaesOptions options, Kind kind = Kind::ipop, int restarts = 9);

  int restartsDone() const { return run_; }
  int population() const { return current_->population(); }
  Eigen::VectorXd favourite() const override { return current_->favourite(); }
  double sigma() const override { return current_->sigma(); }

protected:
  void sample(Eigen::MatrixXd& candidates) override { candidates = current_->ask(); }
  void update(std::span<const double> costs, std::span<const int> order) override;
  /// Also for the current run, which would otherwise draw the same again.
  void forget() override;
  StopReason converged() const override { return finished_; }

private:
  void restart();

  CmaesOptions options_;
  Kind kind_;
  int restarts_;
  int run_ = 0;         ///< restarts done
  int doublings_ = 0;   ///< of the population
  bool small_ = false;  ///< the current run is one of BIPOP's small ones
  std::int64_t usedBySmall_ = 0, usedByLarge_ = 0;
  std::unique_ptr<Cmaes> current_;
  StopReason finished_ = StopReason::none;
};

}  // namespace plumbline
