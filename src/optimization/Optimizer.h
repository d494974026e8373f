#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace plumbline {

/// Where to search: a start, how far from it the first candidates lie, and a box that no candidate leaves.
struct SearchSpace {
  Eigen::VectorXd start;  ///< inside the box
  Eigen::VectorXd sigma;  ///< standard deviation of the first candidates, per coordinate, above 0
  Eigen::VectorXd lower;  ///< -infinity where there is no bound; empty: no bounds
  Eigen::VectorXd upper;  ///< +infinity where there is no bound; empty: no bounds

  /// The whole of a finite box: start in its middle, sigma 0.3 of its width.
  static SearchSpace box(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);
  /// No bounds, the same sigma everywhere.
  static SearchSpace around(const Eigen::VectorXd& start, double sigma);
  /// Of a list of parameters that each have start, sigma, lower and upper.
  template <typename List>
  static SearchSpace of(const List& parameters) {
    const auto n = static_cast<Eigen::Index>(parameters.size());
    SearchSpace space{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n)};
    Eigen::Index i = 0;
    for (const auto& one : parameters) {
      space.start[i] = one.start;
      space.sigma[i] = one.sigma;
      space.lower[i] = one.lower;
      space.upper[i++] = one.upper;
    }
    return space;
  }
};

/// When to stop; see isDone() and stopReason().
struct StopCriteria {
  double targetCost = -std::numeric_limits<double>::infinity();
  std::int64_t maxEvaluations = std::numeric_limits<std::int64_t>::max();
  std::int64_t maxGenerations = std::numeric_limits<std::int64_t>::max();
  double tolFun = 1e-12;  ///< spread of the costs: of a generation and of the last generations' best
  double tolX = 1e-11;    ///< spread of the candidates, in units of the first sigma
};

enum class StopReason {
  none,
  targetCost,
  maxEvaluations,
  maxGenerations,
  tolFun,
  tolX,
  stagnation,
  condition
};
const char* name(StopReason reason);

/// A minimiser that does not call the cost function, so that the caller may evaluate in any order, on any
/// number of threads or machines:
///
///     while (!optimizer.isDone()) optimizer.tell(costsOf(optimizer.ask()));
///
/// The same space, options, seed and costs give the same bytes. A cost that is not a number counts as worse
/// than any other, so does +infinity; a generation without a single finite cost is discarded and drawn again.
class Optimizer {
public:
  virtual ~Optimizer() = default;
  Optimizer(const Optimizer&) = delete;
  Optimizer& operator=(const Optimizer&) = delete;

  /// The candidates of the generation whose costs come next, one per column, all inside the box; the same
  /// until tell(). With k > 0, below ahead(): those of the k-th generation after it, to be evaluated
  /// meanwhile.
  const Eigen::MatrixXd& ask(int k = 0);
  /// Costs of ask(0), in the order of the columns. Throws std::invalid_argument for another number of costs
  /// and std::logic_error where nothing was asked.
  void tell(std::span<const double> costs);
  /// How many generations may be evaluated at a time; each is drawn as soon as the costs of the one `ahead`
  /// before it are known, so the order of evaluation has no effect.
  int ahead() const { return ahead_; }

  int dimension() const { return static_cast<int>(space_.start.size()); }
  const SearchSpace& space() const { return space_; }
  std::int64_t evaluations() const { return evaluations_; }
  std::int64_t generations() const { return generations_; }
  /// The best candidate evaluated so far; the start and +infinity before any.
  const Eigen::VectorXd& best() const { return best_; }
  double bestCost() const { return bestCost_; }
  bool isDone() const { return reason_ != StopReason::none; }
  StopReason stopReason() const { return reason_; }
  /// Centre of the distribution, in the box: the better estimate if costs are noisy.
  virtual Eigen::VectorXd favourite() const { return best_; }
  /// How far the candidates spread, in units of the first sigma.
  virtual double sigma() const;

  /// Everything learnt, between tell() and ask(). restore() loads it into an optimiser of the same space and
  /// options that has no costs yet; throws std::invalid_argument for another text. Unless an optimiser
  /// overrides this, the state is all costs, which tell() then gets again.
  virtual std::string save() const;
  virtual void restore(const std::string& state);

protected:
  /// Checks the space; throws std::invalid_argument naming coordinate and value. With ahead > 1 sample() is
  /// called so many times before the first update(), which then belongs to the oldest.
  Optimizer(SearchSpace space, StopCriteria stop, int ahead = 1);
  static constexpr int mostAhead = 64;

  /// Draws a generation, one candidate per column.
  virtual void sample(Eigen::MatrixXd& candidates) = 0;
  /// Learns from costs without NaN (+infinity instead), at least one of them finite; `order` are the columns
  /// from best to worst, equal costs in the order of the columns.
  virtual void update(std::span<const double> costs, std::span<const int> order) = 0;
  /// Called instead of update() if no cost is finite: drops the data of that generation.
  virtual void forget() {}
  /// A reason to stop of its own, asked after each update.
  virtual StopReason converged() const { return StopReason::none; }
  /// Whether it has save() and restore() of its own, so that costs need not be kept.
  virtual bool hasCheckpoint() const { return false; }

  const StopCriteria& stop() const { return stop_; }
  /// Generations drawn, evaluated or not.
  std::int64_t drawn() const { return generations_ + static_cast<std::int64_t>(open_.size()); }
  /// Puts back what was counted, for subclasses that restore a saved state.
  void restoreProgress(std::int64_t evaluations, std::int64_t generations, double bestCost,
                       const Eigen::VectorXd& best, StopReason reason);

private:
  StopReason findReason() const;

  SearchSpace space_;
  StopCriteria stop_;
  int ahead_;
  std::deque<Eigen::MatrixXd> open_;  ///< generations drawn and not evaluated, the oldest first
  Eigen::MatrixXd last_;              ///< the one evaluated last
  std::int64_t evaluations_ = 0, generations_ = 0;
  Eigen::VectorXd best_;
  double bestCost_ = std::numeric_limits<double>::infinity();
  StopReason reason_ = StopReason::none;
  std::vector<double> costs_;  ///< all costs, unless it saves itself
};

/// Runs until done, one evaluation after the other; gives the best cost.
double minimize(Optimizer& optimizer, const std::function<double(const Eigen::VectorXd&)>& cost);

}  // namespace plumbline
