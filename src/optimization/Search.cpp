#include "optimization/Search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

#include "math/Random.h"

namespace plumbline {
namespace {

/// Candidates of a generation get numbers from here on: a restart with more of them moves no other's.
constexpr std::int64_t mostCandidates = std::int64_t{1} << 24;

}  // namespace

Search::Search(std::unique_ptr<Optimizer> optimizer, const Averaging& averaging, std::uint64_t seed)
    : optimizer_(std::move(optimizer)), averaging_(averaging), seed_(seed) {
  for (const int runs : {averaging.first, averaging.best})
    if (runs < 1 || runs > mostRuns)
      throw std::invalid_argument("a candidate is run " + std::to_string(runs) + " times; 1 to " +
                                  std::to_string(mostRuns) + " are possible");
  if (averaging.best < averaging.first)
    throw std::invalid_argument("the best are run " + std::to_string(averaging.best) +
                                " times, fewer than all, " + std::to_string(averaging.first));
  open();
}

void Search::open() {
  if (isDone()) return;
  while (generations_.size() < static_cast<std::size_t>(optimizer_->ahead())) {
    const auto count = optimizer_->ask(static_cast<int>(generations_.size())).cols();
    generations_.emplace_back().candidates.resize(static_cast<std::size_t>(count));
  }
}

int Search::runsOf(int round) const {
  return round == 0 ? averaging_.first : averaging_.best - averaging_.first;
}

Trial Search::trialAt(const Place& place) const {
  Trial trial;
  trial.generation = firstGeneration_ + static_cast<std::int64_t>(place.generation);
  const auto candidate = static_cast<std::int64_t>(place.candidate);
  trial.number = (trial.generation * mostCandidates + candidate) * 2 + place.round;
  trial.candidate = trial.generation * mostCandidates + candidate;
  trial.parameters = optimizer_->ask(static_cast<int>(place.generation)).col(candidate);
  // Runs of the second round follow those of the first.
  Random random(seed_ * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(trial.generation) * 2 +
                (averaging_.sameSeeds ? 0 : static_cast<std::uint64_t>(trial.candidate) * 2 + 1));
  for (int i = 0; i < (place.round == 0 ? 0 : averaging_.first); ++i) random.next();
  for (int i = 0; i < runsOf(place.round); ++i) trial.seeds.push_back(random.next() >> 32);
  return trial;
}

std::optional<Trial> Search::next() {
  if (isDone()) return std::nullopt;
  for (std::size_t g = 0; g < generations_.size(); ++g) {
    Generation& generation = generations_[g];
    for (std::size_t c = 0; c < generation.candidates.size(); ++c)
      for (const int round : {0, 1}) {
        Candidate& candidate = generation.candidates[c];
        if (candidate.asked[round] || (round == 1 && !candidate.wanted)) continue;
        candidate.asked[round] = true;
        return trialAt({g, c, round});
      }
  }
  return std::nullopt;
}

std::optional<Search::Place> Search::placeOf(std::int64_t number) const {
  if (number < 0) return std::nullopt;
  const int round = static_cast<int>(number % 2);
  const std::int64_t candidate = number / 2 % mostCandidates,
                     generation = number / 2 / mostCandidates - firstGeneration_;
  if (generation < 0 || generation >= static_cast<std::int64_t>(generations_.size())) return std::nullopt;
  const Place place{static_cast<std::size_t>(generation), static_cast<std::size_t>(candidate), round};
  const std::vector<Candidate>& all = generations_[place.generation].candidates;
  if (place.candidate >= all.size() || (round == 1 && !all[place.candidate].wanted)) return std::nullopt;
  return place;
}

std::optional<Trial> Search::find(std::int64_t number) const {
  const std::optional<Place> place = placeOf(number);
  if (isDone() || !place) return std::nullopt;
  const Candidate& candidate = generations_[place->generation].candidates[place->candidate];
  if (candidate.evaluated[place->round]) return std::nullopt;
  return trialAt(*place);
}

ResultStatus Search::take(std::int64_t number, std::span<const double> costs) {
  const std::optional<Place> place = placeOf(number);
  if (!place || isDone()) {
    const bool was = number >= 0 && number / 2 / mostCandidates < firstGeneration_;
    return was || isDone() ? ResultStatus::again : ResultStatus::unknown;
  }
  Generation& generation = generations_[place->generation];
  Candidate& candidate = generation.candidates[place->candidate];
  if (candidate.evaluated[place->round]) return ResultStatus::again;
  if (costs.size() != static_cast<std::size_t>(runsOf(place->round)))
    throw std::invalid_argument(std::to_string(costs.size()) + " costs for " +
                                std::to_string(runsOf(place->round)) + " runs");
  candidate.asked[place->round] = candidate.evaluated[place->round] = true;
  for (const double cost : costs) candidate.sum += std::isnan(cost) || cost == -HUGE_VAL ? HUGE_VAL : cost;
  candidate.runs += static_cast<int>(costs.size());
  ++trials_;
  runs_ += static_cast<std::int64_t>(costs.size());
  if (!generation.second) beginSecond(generation);
  advance();
  return ResultStatus::taken;
}

ResultStatus Search::tell(std::int64_t number, std::span<const double> costs) {
  const ResultStatus status = take(number, costs);
  if (status == ResultStatus::taken)
    notNumbers_ += std::ranges::count_if(costs, [](double cost) { return std::isnan(cost); });
  return status;
}

ResultStatus Search::giveUp(std::int64_t number) {
  const std::vector<double> none(static_cast<std::size_t>(runsOf(static_cast<int>(number & 1))), HUGE_VAL);
  const ResultStatus status = take(number, none);
  if (status == ResultStatus::taken) ++givenUp_;
  return status;
}

void Search::beginSecond(Generation& generation) const {
  std::vector<Candidate>& all = generation.candidates;
  if (averaging_.best == averaging_.first ||
      !std::ranges::all_of(all, [](const Candidate& c) { return c.evaluated[0]; }))
    return;
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return all[i].sum; });
  for (std::size_t i = 0; i < (order.size() + 1) / 2; ++i)
    all[order[i]].wanted = std::isfinite(all[order[i]].sum);
  generation.second = true;
}

bool Search::complete(const Generation& generation) const {
  return std::ranges::all_of(generation.candidates, [](const Candidate& c) {
    return c.evaluated[0] && (!c.wanted || c.evaluated[1]);
  });
}

void Search::advance() {
  while (!generations_.empty() && complete(generations_.front()) && !isDone()) {
    std::vector<double> costs;
    for (const Candidate& c : generations_.front().candidates) costs.push_back(c.sum / c.runs);
    optimizer_->tell(costs);
    generations_.pop_front();
    ++firstGeneration_;
    open();
  }
}

}  // namespace plumbline
