#pragma once
#include <map>
#include <string>
#include <vector>

#include "framework/ModuleGraph.h"

namespace plumbline {

/// What modules cost [us per cycle], by name.
using ModuleTimes = std::map<std::string, double>;

/// The module graph in Graphviz's language: modules are boxes, with their times if there are some,
/// representations ellipses, threads frames; the areas of a thread are frames of one colour each. A full line
/// is REQUIRES or PROVIDES, a grey one REQUIRES_IF_PROVIDED, a dashed one USES, a dotted one a copy; a legend
/// says so.
std::string graphText(const std::vector<ThreadPlan>& threads, const ModuleTimes& times = {});

/// Writes the graph to a .dot file or, through Graphviz's program `dot`, to .svg, .pdf or .png. Throws
/// ConfigurationError if that cannot be done, also if `dot` takes more than a minute, and Stopped after a
/// signal that is caught; then no file is left behind.
void writeGraph(const std::vector<ThreadPlan>& threads, const std::string& path,
                const ModuleTimes& times = {});

}  // namespace plumbline
