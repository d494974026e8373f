#include "modules/behavior/formation/Assignment.h"

#include <limits>
#include <stdexcept>

namespace plumbline {

std::vector<int> assign(const std::vector<std::vector<double>>& cost) {
  const std::size_t workers = cost.size();
  if (workers == 0) return {};
  const std::size_t jobs = cost[0].size();
  if (jobs < workers) throw std::invalid_argument("assign: fewer jobs than workers");
  constexpr double infinite = std::numeric_limits<double>::infinity();
  // Index 0 is nobody; workers and jobs count from 1.
  std::vector<double> priceOfWorker(workers + 1, 0), priceOfJob(jobs + 1, 0);
  std::vector<std::size_t> workerOf(jobs + 1, 0), before(jobs + 1, 0);
  std::vector<double> least;
  std::vector<char> used;
  for (std::size_t worker = 1; worker <= workers; ++worker) {
    least.assign(jobs + 1, infinite);
    used.assign(jobs + 1, false);
    std::size_t job = 0;
    workerOf[0] = worker;
    do {
      used[job] = true;
      const std::size_t here = workerOf[job];
      std::size_t next = 0;
      double step = infinite;
      for (std::size_t j = 1; j <= jobs; ++j) {
        if (used[j]) continue;
        const double reduced = cost[here - 1][j - 1] - priceOfWorker[here] - priceOfJob[j];
        if (reduced < least[j]) {
          least[j] = reduced;
          before[j] = job;
        }
        if (least[j] < step) {
          step = least[j];
          next = j;
        }
      }
      if (next == 0) throw std::invalid_argument("assign: a cost is not finite");
      for (std::size_t j = 0; j <= jobs; ++j)
        if (used[j]) {
          priceOfWorker[workerOf[j]] += step;
          priceOfJob[j] -= step;
        } else {
          least[j] -= step;
        }
      job = next;
    } while (workerOf[job] != 0);
    for (; job != 0; job = before[job]) workerOf[job] = workerOf[before[job]];
  }
  std::vector<int> jobOf(workers, -1);
  for (std::size_t j = 1; j <= jobs; ++j)
    if (workerOf[j] != 0) jobOf[workerOf[j] - 1] = static_cast<int>(j) - 1;
  return jobOf;
}

}  // namespace plumbline
