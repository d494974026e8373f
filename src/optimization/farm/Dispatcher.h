#pragma once
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "optimization/Search.h"

namespace plumbline::farm {

struct DispatchOptions {
  double patience = 600;  ///< with a worker that does not answer [s]; its trial then goes to another one
  int mostFailures = 10;  ///< workers that a trial may cost before it is given up
};

/// What happened to an answer.
enum class Taken {
  counted,
  again,     ///< another worker had answered: not counted
  asksMore,  ///< not a number: another worker must confirm it
  wrong      ///< not the worker's trial, or a wrong number of costs: the worker is wrong
};

struct DispatchCounts {
  std::int64_t answers = 0, again = 0, wrong = 0, doubted = 0, lost = 0, hung = 0;
};

/// Distributes a search's trials over workers, takes answers, and hands out again the trials of a worker that
/// disconnected or hangs. A trial is counted once, whoever answers. It has no sockets and no clock: times [s]
/// are arguments and must not decrease.
class Dispatcher {
public:
  /// Called with each answer that counts, before the search gets it; given up: without costs.
  using Record = std::function<void(const Trial& trial, std::span<const double> costs, int worker)>;

  Dispatcher(Search& search, const DispatchOptions& options, Record record = {});

  int join();
  /// Its trial, if it had one, goes to another worker.
  void leave(int worker);
  /// Work for a worker that has none; nothing: there is none now.
  std::optional<Trial> give(int worker, double now);
  Taken take(int worker, std::int64_t number, std::span<const double> costs);
  /// Hands on what hanging workers have; those workers stay and may yet answer.
  void expire(double now);

  std::size_t workers() const { return workers_.size(); }
  std::size_t busy() const;
  const DispatchCounts& counts() const { return counts_; }
  Search& search() { return search_; }

private:
  struct Worker {
    std::optional<std::int64_t> trial;
    double since = 0;
    bool hangs = false;
  };
  struct Open {
    int failures = 0;
    bool doubted = false;
    int holders = 0;  ///< workers that have it and are not thought to hang
  };
  void failed(std::int64_t number);
  void settle(const Trial& trial, std::span<const double> costs, int worker, bool given);

  Search& search_;
  DispatchOptions options_;
  Record record_;
  std::map<int, Worker> workers_;
  std::map<std::int64_t, Open> open_;
  std::set<std::int64_t> waiting_;  ///< to be handed out again, the oldest first
  int nextWorker_ = 0;
  DispatchCounts counts_;
};

}  // namespace plumbline::farm
