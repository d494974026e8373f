#include "gap/inference/Posterior.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "gap/inference/Strengths.h"
#include "math/Random.h"

namespace plumbline::gap {

std::vector<double> posterior(const std::vector<Scored>& sets, std::uint64_t seed) {
  constexpr int draws = 400;
  std::vector<double> sum(sets.size(), 0.0);
  if (sets.empty()) return sum;
  Random random(seed);
  const std::size_t groups = sets.front().gain.size();
  std::vector<double> weight(groups), score(sets.size());
  for (int draw = 0; draw < draws; ++draw) {
    double total = 0;
    for (double& w : weight) total += w = -std::log(1 - random.uniform());
    for (double& w : weight) w *= static_cast<double>(groups) / total;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      score[i] = -sets[i].price;
      for (std::size_t g = 0; g < groups; ++g) score[i] += weight[g] * sets[i].gain[g];
    }
    const double best = *std::ranges::max_element(score);
    double all = 0;
    for (double& s : score) all += s = std::exp(s - best);
    for (std::size_t i = 0; i < sets.size(); ++i) sum[i] += score[i] / all / draws;
  }
  return sum;
}

double probabilityOf(const Cause& cause, const std::vector<Scored>& sets, const std::vector<double>& p) {
  double sum = 0;
  for (std::size_t i = 0; i < sets.size(); ++i)
    if (std::ranges::any_of(sets[i].causes(), [&](const Cause& c) { return c.sameKind(cause); })) sum += p[i];
  return std::min(1.0, sum);
}

Bounds intervalOf(const Scored& scored, std::size_t i, const Mechanism& robot) {
  constexpr double deviations = 1.96;
  const Explanation& causes = scored.causes();
  const auto n = static_cast<Eigen::Index>(causes.size()), at = static_cast<Eigen::Index>(i);
  Eigen::MatrixXd information = 1e-6 * Eigen::MatrixXd::Identity(n, n);
  for (const Eigen::MatrixXd& of : scored.fitted.information) information += of;
  const Eigen::VectorXd unit = Eigen::VectorXd::Unit(n, at);
  double variance = information.llt().solve(unit)[at];
  const auto groups = static_cast<double>(scored.without.size());
  if (groups > 1) {
    double mean = 0, squares = 0;
    std::vector<double> values;
    for (const Explanation& without : scored.without) values.push_back(logStrengths(without)[at]);
    for (const double value : values) mean += value / groups;
    for (const double value : values) squares += (value - mean) * (value - mean);
    variance = std::max(variance, (groups - 1) / groups * squares);
  }
  const double half = deviations * std::min(2.0, std::sqrt(variance));
  Eigen::VectorXd x = logStrengths(causes);
  x[at] += half;
  const double one = withLogStrengths(robot, causes, x)[i].value;
  x[at] -= 2 * half;
  const double other = withLogStrengths(robot, causes, x)[i].value;
  return {std::min(one, other), std::max(one, other)};
}

}  // namespace plumbline::gap
