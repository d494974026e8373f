#include "framework/TimingReport.h"

#include <algorithm>
#include <cstdio>

#include "framework/Process.h"

namespace plumbline {
namespace {

constexpr std::size_t nameWidth = 46;

void addLine(std::string& text, const std::string& name, const Stopwatch& watch) {
  char numbers[160];
  std::snprintf(numbers, sizeof(numbers), "%10llu %9.1f %9.1f %9.1f %9.1f %9.1f\n",
                static_cast<unsigned long long>(watch.count()), 1e6 * watch.min(), 1e6 * watch.mean(),
                1e6 * watch.percentile(0.5), 1e6 * watch.percentile(0.99), 1e6 * watch.max());
  text += name;
  text.append(name.size() < nameWidth ? nameWidth - name.size() : 1, ' ');
  text += numbers;
}

/// The modules' own stopwatches, "timing:Module:name", are listed between those of their steps.
void addOwn(std::string& text, const TimingPlugin& timing, const std::string& module,
            const AgentStopwatches& stopwatches) {
  const std::string prefix = "timing:" + module + ":";
  for (auto at = stopwatches.lower_bound(prefix); at != stopwatches.end() && at->first.starts_with(prefix);
       ++at) {
    const std::string name = at->first.substr(std::string("timing:").size());
    const bool step = std::ranges::any_of(
        timing.steps(), [&](const TimingPlugin::Entry& entry) { return entry.name == name; });
    if (!step) addLine(text, "  " + name, *at->second);
  }
}

std::string threadLine(const TimingPlugin& timing) {
  char line[160];
  std::snprintf(line, sizeof(line), "[%s] load %.1f %%", timing.thread().c_str(), 100 * timing.load());
  std::string text = line;
  if (timing.rate() <= 0) return text + "\n";
  std::snprintf(line, sizeof(line), "; at %g Hz %llu of %llu cycles ran over", timing.rate(),
                static_cast<unsigned long long>(timing.overruns()),
                static_cast<unsigned long long>(timing.cycle().count()));
  text += line;
  const char* separator = ", longest in ";
  for (const TimingPlugin::Entry& entry : timing.steps()) {
    const auto count = entry.overruns.load(std::memory_order_relaxed);
    if (count == 0) continue;
    text += separator + entry.name + " " + std::to_string(count);
    separator = ", ";
  }
  return text + "\n";
}

}  // namespace

std::string timingReport(const TimingPlugin& timing, const AgentStopwatches& stopwatches) {
  std::string text = threadLine(timing);
  std::string head = "microseconds";
  head.append(nameWidth - head.size(), ' ');
  text += head + "     count       min      mean    median       99%       max\n";
  addLine(text, "cycle", timing.cycle());
  addLine(text, "cycle without waiting", timing.busy());
  addLine(text, "processor time per cycle", timing.cpu());
  const std::string* module = nullptr;
  for (const TimingPlugin::Entry& entry : timing.steps()) {
    addLine(text, entry.name, *entry.stopwatch);
    if (module && *module == entry.module) continue;
    module = &entry.module;
    addOwn(text, timing, entry.module, stopwatches);
  }
  return text;
}

std::map<std::string, double> moduleTimes(const Process& process) {
  const TimingPlugin& timing = process.timing();
  std::map<std::string, double> times;
  for (const Step& step : process.info().steps)
    times[step.module] += 1e6 * timing.steps()[step.index].stopwatch->mean();
  return times;
}

}  // namespace plumbline
