#pragma once
#include <string>

namespace plumbline {

/// Draws a graph with Graphviz: `dot -Tformat input -o output`. Returns what went wrong, or an empty text. A
/// program that has not drawn it after `seconds` of the clock is killed. Throws Stopped if a signal that is
/// caught (StopSignal) comes meanwhile. Nothing of it runs on in any case.
std::string runDot(const std::string& format, const std::string& input, const std::string& output,
                   double seconds);

}  // namespace plumbline
