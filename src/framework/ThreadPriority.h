#pragma once
#include <string>

namespace plumbline {

/// Gives the calling thread a priority of modules.cfg, where `highest` is the highest below 15 in the agent.
/// 15 is real time (SCHED_FIFO); below, one level is one step of nice, the highest one staying as the process
/// was started: that needs no privileges. Returns an empty string, or why it was refused; that is never
/// fatal.
std::string applyThreadPriority(int priority, int highest);

}  // namespace plumbline
