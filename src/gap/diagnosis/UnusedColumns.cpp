#include "gap/diagnosis/UnusedColumns.h"

#include <set>

#include "gap/diagnosis/Evidence.h"
#include "gap/replay/TrialOf.h"

namespace plumbline::gap {

std::string whyNeverUsed(SignalKind kind) {
  if (kind == SignalKind::velocity) return "it is the derivative of the position, which is used";
  if (kind == SignalKind::truth) return "a body's way over the ground is shown, not scored";
  return "";
}

std::vector<std::string> unusedColumns(
    const std::vector<Trial>& trials,
    const std::function<std::string(std::size_t trial, std::size_t signal)>& whyNot) {
  std::set<std::string> lines;
  for (std::size_t t = 0; t < trials.size(); ++t) {
    lines.insert(trials[t].unused.begin(), trials[t].unused.end());
    for (std::size_t s = 0; s < trials[t].signals.size(); ++s)
      if (const std::string why = whyNot(t, s); !why.empty())
        lines.insert(unusedLine(trials[t].signals[s].name, why));
  }
  return {lines.begin(), lines.end()};
}

std::vector<std::string> unusedByBlocks(const std::vector<Trial>& trials) {
  return unusedColumns(trials, [&](std::size_t t, std::size_t s) -> std::string {
    const Signal& signal = trials[t].signals[s];
    if (Evidence::counts(signal)) return "";
    if (const std::string why = whyNeverUsed(signal.kind); !why.empty()) return why;
    return "--method blocks does not look at it; --method sets does";
  });
}

}  // namespace plumbline::gap
