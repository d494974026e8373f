#pragma once
#include <string>

namespace plumbline {

class Process;

/// A table of a thread's stopwatches in microseconds: cycle, processor time, every step, and what its modules
/// measured through their debug objects. Debug stopwatches may only be read when the thread has ended.
std::string timingReport(const Process& process);

}  // namespace plumbline
