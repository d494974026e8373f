#pragma once
#include <string>
#include <vector>

#include "framework/ModuleGraph.h"

namespace plumbline {

/// The module graph in Graphviz's language: modules are boxes, representations ellipses, threads frames; a
/// full line is REQUIRES or PROVIDES, a grey one REQUIRES_IF_PROVIDED, a dashed one USES, a dotted one a
/// copy.
std::string graphText(const std::vector<ThreadPlan>& threads);

/// Writes the graph to a .dot file or, through Graphviz's program `dot`, to .svg, .pdf or .png. Throws
/// ConfigurationError if that cannot be done; then no file is left behind.
void writeGraph(const std::vector<ThreadPlan>& threads, const std::string& path);

}  // namespace plumbline
