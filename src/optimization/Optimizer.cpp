#include "optimization/Optimizer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace plumbline {
namespace {

constexpr std::string_view savedMark = "costs of a search\n";

[[noreturn]] void fail(const std::string& what, Eigen::Index coordinate, double value) {
  throw std::invalid_argument("search space: " + what + " of coordinate " + std::to_string(coordinate) +
                              " is " + std::to_string(value));
}

void check(SearchSpace& space) {
  const Eigen::Index n = space.start.size();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (n == 0) throw std::invalid_argument("search space: no coordinates");
  if (space.lower.size() == 0) space.lower = Eigen::VectorXd::Constant(n, -infinity);
  if (space.upper.size() == 0) space.upper = Eigen::VectorXd::Constant(n, infinity);
  for (const Eigen::VectorXd* v : {&space.sigma, &space.lower, &space.upper})
    if (v->size() != n)
      throw std::invalid_argument("search space: " + std::to_string(v->size()) + " numbers for " +
                                  std::to_string(n) + " coordinates");
  for (Eigen::Index i = 0; i < n; ++i) {
    if (!std::isfinite(space.start[i])) fail("the start", i, space.start[i]);
    if (!(space.sigma[i] > 0) || !std::isfinite(space.sigma[i])) fail("sigma", i, space.sigma[i]);
    if (!(space.lower[i] < space.upper[i])) fail("the lower bound, not below the upper,", i, space.lower[i]);
    if (space.start[i] < space.lower[i] || space.start[i] > space.upper[i])
      fail("the start, outside its bounds,", i, space.start[i]);
  }
}

}  // namespace

SearchSpace SearchSpace::box(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  return {0.5 * (lower + upper), 0.3 * (upper - lower), lower, upper};
}

SearchSpace SearchSpace::around(const Eigen::VectorXd& start, double sigma) {
  return {start, Eigen::VectorXd::Constant(start.size(), sigma), {}, {}};
}

const char* name(StopReason reason) {
  switch (reason) {
    case StopReason::none:
      return "none";
    case StopReason::targetCost:
      return "targetCost";
    case StopReason::maxEvaluations:
      return "maxEvaluations";
    case StopReason::maxGenerations:
      return "maxGenerations";
    case StopReason::tolFun:
      return "tolFun";
    case StopReason::tolX:
      return "tolX";
    case StopReason::stagnation:
      return "stagnation";
    case StopReason::condition:
      return "condition";
  }
  return "none";
}

Optimizer::Optimizer(SearchSpace space, StopCriteria stop, int ahead)
    : space_(std::move(space)), stop_(stop), ahead_(ahead) {
  if (ahead < 1 || ahead > mostAhead)
    throw std::invalid_argument("ahead is " + std::to_string(ahead) + "; 1 to " + std::to_string(mostAhead) +
                                " generations may be evaluated at a time");
  check(space_);
  best_ = space_.start;
}

const Eigen::MatrixXd& Optimizer::ask(int k) {
  if (k < 0 || k >= ahead_)
    throw std::logic_error("Optimizer::ask: generation " + std::to_string(k) + " of " +
                           std::to_string(ahead_) + " that may be asked");
  while (open_.size() < static_cast<std::size_t>(ahead_)) {
    Eigen::MatrixXd candidates;
    sample(candidates);
    open_.push_back(std::move(candidates));
  }
  return open_[static_cast<std::size_t>(k)];
}

void Optimizer::tell(std::span<const double> costs) {
  if (open_.empty()) throw std::logic_error("Optimizer::tell before ask");
  if (static_cast<Eigen::Index>(costs.size()) != open_.front().cols())
    throw std::invalid_argument("Optimizer::tell: " + std::to_string(costs.size()) + " costs for " +
                                std::to_string(open_.front().cols()) + " candidates");
  last_ = std::move(open_.front());
  open_.pop_front();
  if (!hasCheckpoint()) costs_.insert(costs_.end(), costs.begin(), costs.end());
  std::vector<double> clean(costs.begin(), costs.end());
  for (double& cost : clean)
    if (std::isnan(cost)) cost = std::numeric_limits<double>::infinity();
  std::vector<int> order(clean.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](int i) { return clean[static_cast<std::size_t>(i)]; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return at(a) < at(b); });
  evaluations_ += static_cast<std::int64_t>(clean.size());
  ++generations_;
  const double first = at(order[0]);
  if (first < bestCost_) {
    bestCost_ = first;
    best_ = last_.col(order[0]);
  }
  if (first < std::numeric_limits<double>::infinity())
    update(clean, order);
  else
    forget();
  reason_ = findReason();
}

StopReason Optimizer::findReason() const {
  if (bestCost_ <= stop_.targetCost) return StopReason::targetCost;
  if (const StopReason own = converged(); own != StopReason::none) return own;
  if (evaluations_ >= stop_.maxEvaluations) return StopReason::maxEvaluations;
  return generations_ >= stop_.maxGenerations ? StopReason::maxGenerations : StopReason::none;
}

double Optimizer::sigma() const {
  const Eigen::MatrixXd& candidates = open_.empty() ? last_ : open_.back();
  if (candidates.cols() < 2) return 1;
  const Eigen::VectorXd middle = candidates.rowwise().mean();
  const Eigen::VectorXd variances =
      (candidates.colwise() - middle).rowwise().squaredNorm() / static_cast<double>(candidates.cols() - 1);
  return std::sqrt(variances.cwiseQuotient(space_.sigma.cwiseAbs2()).mean());
}

std::string Optimizer::save() const {
  const auto dimension64 = static_cast<std::uint64_t>(dimension());
  std::string state(savedMark);
  state.append(reinterpret_cast<const char*>(&dimension64), sizeof dimension64);
  state.append(reinterpret_cast<const char*>(costs_.data()), costs_.size() * sizeof(double));
  return state;
}

void Optimizer::restore(const std::string& state) {
  if (evaluations_ > 0) throw std::logic_error("Optimizer::restore: it has already been told costs");
  std::uint64_t dimension64 = 0;
  const std::size_t header = savedMark.size() + sizeof dimension64;
  if (state.size() < header || !state.starts_with(savedMark))
    throw std::invalid_argument("Optimizer::restore: the state is of another search");
  std::memcpy(&dimension64, state.data() + savedMark.size(), sizeof dimension64);
  if (dimension64 != static_cast<std::uint64_t>(dimension()))
    throw std::invalid_argument("Optimizer::restore: the state is of another search");
  std::vector<double> costs((state.size() - header) / sizeof(double));
  if (header + costs.size() * sizeof(double) != state.size())
    throw std::invalid_argument("Optimizer::restore: the state is cut short");
  if (!costs.empty()) std::memcpy(costs.data(), state.data() + header, costs.size() * sizeof(double));
  for (std::size_t at = 0; at < costs.size();) {
    const auto size = static_cast<std::size_t>(ask().cols());
    if (isDone() || size > costs.size() - at)
      throw std::invalid_argument("Optimizer::restore: the state is of another search");
    tell(std::span(costs).subspan(at, size));
    at += size;
  }
}

void Optimizer::restoreProgress(std::int64_t evaluations, std::int64_t generations, double bestCost,
                                const Eigen::VectorXd& best, StopReason reason) {
  evaluations_ = evaluations;
  generations_ = generations;
  bestCost_ = bestCost;
  best_ = best;
  reason_ = reason;
  open_.clear();
}

double minimize(Optimizer& optimizer, const std::function<double(const Eigen::VectorXd&)>& cost) {
  std::vector<double> costs;
  while (!optimizer.isDone()) {
    const Eigen::MatrixXd& candidates = optimizer.ask();
    costs.clear();
    for (Eigen::Index i = 0; i < candidates.cols(); ++i) costs.push_back(cost(candidates.col(i)));
    optimizer.tell(costs);
  }
  return optimizer.bestCost();
}

}  // namespace plumbline
