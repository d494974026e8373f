#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

#include "math/Random.h"
#include "training/SearchTask.h"

namespace plumbline::training {
namespace {

/// Functions of the textbooks, to try optimisers and servers on: the least cost is 0. Options: function,
/// dimension, noise (standard deviation that is added), sleep [s] and its deviation `spread` (a share).
/// Figure: slept [s].
class FunctionTask : public SearchTask {
public:
  explicit FunctionTask(const TaskOptions& options)
      : function_(options.word("function", "sphere", {"sphere", "ellipsoid", "rosenbrock", "rastrigin"})),
        noise_(options.number("noise", 0, 0, 1e6)),
        sleep_(options.number("sleep", 0, 0, 3600)),
        spread_(options.number("spread", 0, 0, 1)) {
    options.check({"function", "dimension", "noise", "sleep", "spread"});
    const int n = static_cast<int>(options.number("dimension", 10, 1, 10000));
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

MAKE_TASK(function, {"function", "functions of the textbooks: function, dimension, noise, sleep, spread",
                     [](const TaskOptions& options) -> std::unique_ptr<SearchTask> {
                       return std::make_unique<FunctionTask>(options);
                     }});

}  // namespace plumbline::training
