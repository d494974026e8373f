#pragma once
#include <map>
#include <memory>
#include <string>

#include "framework/Stopwatch.h"

namespace plumbline {

class Process;
class TimingPlugin;

/// By id, "timing:Module:name".
using AgentStopwatches = std::map<std::string, std::shared_ptr<const Stopwatch>>;

/// A table of a thread's stopwatches: what each step took, and the modules' own among `stopwatches`; above it
/// the thread's load and, where it has a rate, which cycles ran over. May be read while the thread runs.
std::string timingReport(const TimingPlugin& timing, const AgentStopwatches& stopwatches);

/// What each module of a thread cost [us per cycle], by name.
std::map<std::string, double> moduleTimes(const Process& process);

}  // namespace plumbline
