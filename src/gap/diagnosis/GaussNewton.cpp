#include "gap/diagnosis/GaussNewton.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "framework/Parallel.h"
#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

namespace {

constexpr int steps = 12, tries = 4;
// Steps of a strength for the derivative: sticking and limits are not smooth, so one step may show a
// direction where another does not.
constexpr std::array shares = {0.02, 0.004, 0.08};
constexpr double longest = 0.7;   // step of the logarithm of a strength
constexpr double minGain = 2e-4;  // share of the squares: a step that gains less is the last
constexpr double atLeast = 0.1;   // squares, likewise
constexpr double damped = 1e-3;   // at first, of the diagonal

using Predictions = std::vector<Prediction>;

struct Slopes {
  Eigen::MatrixXd normal;    ///< J^T W J
  Eigen::VectorXd downhill;  ///< J^T W r
};

class Steps {
public:
  Steps(const Evaluator& evaluator, const Explanation& causes, const std::vector<std::size_t>& group,
        int jobs)
      : evaluator_(evaluator), group_(group), jobs_(jobs) {
    at_.causes = causes;
    played_ = evaluator_.played(causes);
    at_.fitting = evaluator_.compare(played_).fitting;
  }

  GaussNewtonFit run() {
    double damping = damped;
    std::size_t share = 0;
    for (int step = 0; step < steps && !at_.settled; ++step) {
      if (take(slopesHere(shares[share]), damping)) continue;
      if (++share == shares.size()) break;
      damping = damped;
    }
    return at_;
  }

private:
  Explanation moved(const Eigen::VectorXd& x) const {
    Explanation causes = at_.causes;
    for (std::size_t i = 0; i < group_.size(); ++i)
      causes[group_[i]] =
          scaled(evaluator_.mechanism(), causes[group_[i]], std::exp(x[static_cast<Eigen::Index>(i)]));
    return causes;
  }

  /// Prediction of a signal: the base's if the signal was not replayed.
  const std::vector<double>& valuesOf(const Predictions& p, std::size_t t, std::size_t s) const {
    const bool own = s < p[t].values.size() && !p[t].values[s].empty();
    return own ? p[t].values[s] : evaluator_.basePrediction(t).values[s];
  }

  Slopes slopesHere(double share) const {
    const auto n = static_cast<Eigen::Index>(group_.size());
    std::vector<Predictions> perturbed(group_.size());
    Eigen::VectorXd stride(n);
    for (Eigen::Index i = 0; i < n; ++i) stride[i] = strengthens(i, share) ? share : -share;
    parallel(group_.size(), jobs_, [&](std::size_t i) {
      const auto k = static_cast<Eigen::Index>(i);
      perturbed[i] = evaluator_.played(moved(stride[k] * Eigen::VectorXd::Unit(n, k)));
    });
    Slopes slopes{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
    const Evidence& data = evaluator_.evidence();
    Eigen::VectorXd change(n);
    for (std::size_t t = 0; t < data.trials().size(); ++t)
      for (std::size_t s = 0; s < data.trials()[t].signals.size(); ++s) {
        // The uncertainty of a prediction counts when a step is judged, not here.
        Prediction here;
        here.values.resize(s + 1);
        here.values[s] = valuesOf(played_, t, s);
        if (here.values[s].empty()) continue;
        std::vector<const std::vector<double>*> shifted;
        shifted.reserve(perturbed.size());
        for (const Predictions& p : perturbed) shifted.push_back(&valuesOf(p, t, s));
        data.forEach(t, s, here, [&](std::size_t k, double w, double r) {
          if (!Evidence::forFitting(data.block(t, k))) return;
          for (Eigen::Index i = 0; i < n; ++i) {
            const double d = (*shifted[static_cast<std::size_t>(i)])[k] - here.values[s][k];
            change[i] = std::isfinite(d) ? d / stride[i] : 0;
          }
          slopes.normal.noalias() += w * change * change.transpose();
          slopes.downhill.noalias() += w * r * change;
        });
      }
    return slopes;
  }

  bool strengthens(Eigen::Index i, double by) const {
    const auto n = static_cast<Eigen::Index>(group_.size());
    const std::size_t k = group_[static_cast<std::size_t>(i)];
    return moved(by * Eigen::VectorXd::Unit(n, i))[k].value != at_.causes[k].value;
  }

  /// Takes one step downhill, with more damping until one succeeds; false if none does.
  bool take(const Slopes& slopes, double& damping) {
    for (int attempt = 0; attempt < tries; ++attempt, damping *= 10) {
      Eigen::MatrixXd normal = slopes.normal;
      normal.diagonal() *= 1 + damping;
      normal.diagonal().array() += 1e-9;
      const Eigen::VectorXd x = normal.ldlt().solve(slopes.downhill).cwiseMax(-longest).cwiseMin(longest);
      const Explanation tried = moved(x);
      Predictions there = evaluator_.played(tried);
      const double fitting = evaluator_.compare(there).fitting;
      if (!(fitting < at_.fitting)) continue;
      at_.settled = damping < 1 && at_.fitting - fitting < std::max(atLeast, minGain * at_.fitting);
      at_.causes = tried;
      at_.fitting = fitting;
      played_ = std::move(there);
      damping = std::max(1e-6, damping / 10);
      return true;
    }
    return false;
  }

  const Evaluator& evaluator_;
  const std::vector<std::size_t>& group_;
  const int jobs_;
  GaussNewtonFit at_;
  Predictions played_;
};

}  // namespace

GaussNewtonFit gaussNewton(const Evaluator& evaluator, const Explanation& causes,
                           const std::vector<std::size_t>& group, int jobs) {
  if (evaluator.hasFloatingBase()) throw std::logic_error("gaussNewton: runs on the feet have no slopes");
  return Steps(evaluator, causes, group, jobs).run();
}

}  // namespace plumbline::gap
