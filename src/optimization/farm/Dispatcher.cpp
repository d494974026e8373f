#include "optimization/farm/Dispatcher.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumbline::farm {

Dispatcher::Dispatcher(Search& search, const DispatchOptions& options, Record record)
    : search_(search), options_(options), record_(std::move(record)) {
  if (!(options.patience > 0) || options.mostFailures < 1)
    throw std::invalid_argument("Dispatcher: patience and mostFailures have to be above 0");
}

int Dispatcher::join() {
  workers_[nextWorker_];
  return nextWorker_++;
}

void Dispatcher::failed(std::int64_t number) {
  const auto found = open_.find(number);
  if (found == open_.end()) return;  // somebody else has answered
  Open& open = found->second;
  ++open.failures;
  if (open.holders > 0) return;
  if (open.failures < options_.mostFailures) {
    waiting_.insert(number);
    return;
  }
  const std::optional<Trial> trial = search_.find(number);
  if (trial) settle(*trial, {}, -1, true);
}

void Dispatcher::leave(int worker) {
  const auto found = workers_.find(worker);
  if (found == workers_.end()) return;
  const Worker gone = found->second;
  workers_.erase(found);
  if (!gone.trial) return;
  ++counts_.lost;
  if (gone.hangs) return;  // handed on already
  if (const auto open = open_.find(*gone.trial); open != open_.end()) --open->second.holders;
  failed(*gone.trial);
}

std::optional<Trial> Dispatcher::give(int worker, double now) {
  Worker& who = workers_.at(worker);
  if (who.trial) throw std::logic_error("Dispatcher: the worker has a trial");
  std::optional<Trial> trial;
  while (!trial && !waiting_.empty()) {
    trial = search_.find(*waiting_.begin());
    waiting_.erase(waiting_.begin());
  }
  if (!trial) trial = search_.next();
  if (!trial) return std::nullopt;
  who = {trial->number, now, false};
  ++open_[trial->number].holders;
  return trial;
}

Taken Dispatcher::take(int worker, std::int64_t number, std::span<const double> costs) {
  Worker& who = workers_.at(worker);
  if (who.trial != number) {
    ++counts_.wrong;
    return Taken::wrong;
  }
  const bool hung = who.hangs;
  const std::optional<Trial> trial = search_.find(number);
  if (trial && trial->seeds.size() != costs.size()) {
    ++counts_.wrong;
    return Taken::wrong;  // who drops the worker lets it leave(), and the trial goes on
  }
  who.trial.reset();
  const auto open = open_.find(number);
  if (!trial || open == open_.end()) {
    ++counts_.again;
    return Taken::again;
  }
  if (!hung) --open->second.holders;
  const bool isNumber = std::ranges::none_of(costs, [](double cost) { return std::isnan(cost); });
  if (!isNumber && !open->second.doubted) {
    open->second.doubted = true;
    ++counts_.doubted;
    if (open->second.holders == 0) waiting_.insert(number);
    return Taken::asksMore;
  }
  ++counts_.answers;
  settle(*trial, costs, worker, false);
  return Taken::counted;
}

void Dispatcher::settle(const Trial& trial, std::span<const double> costs, int worker, bool given) {
  open_.erase(trial.number);
  waiting_.erase(trial.number);
  if (record_) record_(trial, costs, worker);
  if (given)
    search_.giveUp(trial.number);
  else
    search_.tell(trial.number, costs);
}

void Dispatcher::expire(double now) {
  for (auto& [number, worker] : workers_) {
    if (!worker.trial || worker.hangs || now - worker.since < options_.patience) continue;
    worker.hangs = true;
    ++counts_.hung;
    if (const auto open = open_.find(*worker.trial); open != open_.end()) --open->second.holders;
    failed(*worker.trial);
  }
}

std::size_t Dispatcher::busy() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(workers_, [](const auto& entry) { return entry.second.trial.has_value(); }));
}

}  // namespace plumbline::farm
