#include "framework/TimingReport.h"

#include <cstdio>

#include "framework/Process.h"

namespace plumbline {
namespace {

void addLine(std::string& text, const std::string& name, const Stopwatch& watch) {
  char numbers[128];
  std::snprintf(numbers, sizeof(numbers), "%10llu %9.1f %9.1f %9.1f %9.1f\n",
                static_cast<unsigned long long>(watch.count()), 1e6 * watch.mean(),
                1e6 * watch.percentile(0.5), 1e6 * watch.percentile(0.95), 1e6 * watch.max());
  text += name;
  text.append(name.size() < 46 ? 46 - name.size() : 1, ' ');
  text += numbers;
}

}  // namespace

std::string timingReport(const Process& process) {
  const TimingPlugin& timing = process.timing();
  std::string text = "[" + process.name() + "] microseconds";
  text.append(text.size() < 46 ? 46 - text.size() : 1, ' ');
  text += "     count      mean    median       95%       max\n";
  addLine(text, "cycle", timing.cycle());
  addLine(text, "processor time per cycle", timing.cpu());
  for (const Step& step : process.info().steps) {
    addLine(text, step.label, *timing.steps()[step.index].stopwatch);
    if (!step.isExecute()) continue;
    for (const auto& [name, watch] : step.instance->debugStopwatches()) {
      addLine(text, "  " + step.module + ":" + name, *watch);
    }
  }
  return text;
}

}  // namespace plumbline
