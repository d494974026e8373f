#pragma once
#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "math/Random.h"
#include "optimization/farm/Dispatcher.h"

namespace plumbline::farm {

/// Workers in simulated time: nothing but the seeds decides what happens when.
struct SimulatedFarm {
  int workers = 30;
  double spread = 0.3;  ///< standard deviation of evaluation times, whose mean is 1 s
  double kills = 0, hangs = 0, lies = 0, nonsense = 0;  ///< shares of evaluations that end so
  std::uint64_t seed = 1;
  double patience = 20;
  long maxEvents = 10'000'000;

  struct Result {
    double seconds = 0;     ///< until the search was over
    double efficiency = 0;  ///< time of the answers that counted, of all workers' time
    long killed = 0, hung = 0, lied = 0;
    DispatchCounts counts{};
  };

  Result run(Search& search, const std::function<double(const Trial&)>& cost,
             Dispatcher::Record record = {}) const {
    Dispatcher dispatcher(search, {patience, 50}, std::move(record));
    Random random(seed);
    Result result;
    struct Busy {
      int worker;
      Trial trial;
      double took;
      int fate;  ///< 0: answers, 1: killed, 2: hangs, 3: wrong size, 4: not a number
    };
    std::multimap<double, Busy> agenda;
    std::vector<int> idle;
    for (int i = 0; i < workers; ++i) idle.push_back(dispatcher.join());
    double now = 0, useful = 0, nextExpiry = 1;
    const auto give = [&] {
      while (!idle.empty()) {
        const std::optional<Trial> trial = dispatcher.give(idle.back(), now);
        if (!trial) return;
        const double took = std::max(0.05, 1 + spread * random.gaussian()), luck = random.uniform();
        const int fate = luck < kills                             ? 1
                         : luck < kills + hangs                   ? 2
                         : luck < kills + hangs + lies            ? 3
                         : luck < kills + hangs + lies + nonsense ? 4
                                                                  : 0;
        if (fate == 2)
          agenda.emplace(now + 3 * patience, Busy{idle.back(), *trial, took, fate});
        else
          agenda.emplace(now + took, Busy{idle.back(), *trial, took, fate});
        idle.pop_back();
      }
    };
    give();
    for (long i = 0; i < maxEvents && !search.isDone() && !agenda.empty(); ++i) {
      const auto first = agenda.begin();
      if (first->first > nextExpiry) {
        now = nextExpiry++;
        dispatcher.expire(now);
        give();
        continue;
      }
      now = first->first;
      const Busy busy = first->second;
      agenda.erase(first);
      std::vector<double> costs(busy.trial.seeds.size(), cost(busy.trial));
      if (busy.fate == 3) costs.push_back(0);
      if (busy.fate == 4) costs[0] = std::nan("");
      if (busy.fate == 1 || busy.fate == 2) {  // who hangs is killed in the end
        (busy.fate == 1 ? result.killed : result.hung)++;
        dispatcher.leave(busy.worker);
        idle.push_back(dispatcher.join());
      } else {
        const Taken taken = dispatcher.take(busy.worker, busy.trial.number, costs);
        if (taken == Taken::counted) useful += busy.took;
        if (taken == Taken::wrong) {
          ++result.lied;
          dispatcher.leave(busy.worker);
          idle.push_back(dispatcher.join());
        } else {
          idle.push_back(busy.worker);
        }
      }
      give();
    }
    result.seconds = now;
    result.efficiency = useful / (now * workers);
    result.counts = dispatcher.counts();
    return result;
  }
};

}  // namespace plumbline::farm
