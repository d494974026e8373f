#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

#include "math/Random.h"
#include "training/SearchTask.h"

namespace plumbline::training {
namespace {

struct FunctionOptions {
  PARAMETERS(FunctionOptions)
  PARAMETER_CHOICE(function, "sphere", "which one", "sphere", "ellipsoid", "rosenbrock", "rastrigin")
  PARAMETER(int, dimension, 10, "", Range(1, 10000), "number of parameters")
  PARAMETER(double, noise, 0, "", Range(0, 1e6), "standard deviation of what is added to each cost")
  PARAMETER(double, sleep, 0, "s", Range(0, 3600), "time that a run takes")
  PARAMETER(double, spread, 0, "", Range(0, 1), "standard deviation of that time, as a share of it")
};

/// Functions of the textbooks, to try optimisers and servers on: the least cost is 0. Figure: slept [s].
class FunctionTask : public SearchTask {
public:
  using Options = FunctionOptions;
  explicit FunctionTask(const FunctionOptions& options)
      : function_(options.function), noise_(options.noise), sleep_(options.sleep), spread_(options.spread) {
    const int n = options.dimension;
    for (int i = 0; i < n; ++i) {
      std::string name = "x";
      parameters_.push_back(
          {name += std::to_string(i + 1), function_ == "rosenbrock" ? 0.0 : 1.0, -5, 5, 0.5});
    }
  }

  const std::vector<TaskParameter>& parameters() const override { return parameters_; }

  TaskOutcome run(const Eigen::VectorXd& x, std::uint64_t seed) override {
    Random random(seed);
    const double pause = sleep_ * std::max(0.1, 1 + spread_ * random.gaussian());
    if (sleep_ > 0) std::this_thread::sleep_for(std::chrono::duration<double>(pause));
    TaskOutcome outcome{cost(x) + noise_ * random.gaussian()};
    if (sleep_ > 0) outcome.figures = {{"slept", pause}};
    return outcome;
  }

private:
  double cost(const Eigen::VectorXd& x) const {
    if (function_ == "sphere") return x.squaredNorm();
    double sum = 0;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double share = x.size() > 1 ? static_cast<double>(i) / static_cast<double>(x.size() - 1) : 0;
      if (function_ == "ellipsoid") sum += std::pow(1e6, share) * x[i] * x[i];
      if (function_ == "rastrigin") sum += 10 + x[i] * x[i] - 10 * std::cos(2 * std::numbers::pi * x[i]);
      if (function_ == "rosenbrock" && i + 1 < x.size())
        sum += 100 * std::pow(x[i + 1] - x[i] * x[i], 2) + std::pow(1 - x[i], 2);
    }
    return sum;
  }

  std::string function_;
  double noise_, sleep_, spread_;
  std::vector<TaskParameter> parameters_;
};

}  // namespace

MAKE_TASK(FunctionTask, "function", "functions of the textbooks")

}  // namespace plumbline::training
