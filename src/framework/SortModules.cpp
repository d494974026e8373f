#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <string>

#include "framework/ConfigurationError.h"
#include "framework/ModuleGraph.h"

namespace plumbline {
namespace {

/// An edge of the graph of modules: `from` provides what another one requires.
struct Edge {
  std::size_t from;
  std::string representation;
};

/// For each module, the modules of the same thread that must come before it.
std::vector<std::vector<Edge>> edges(const ThreadPlan& thread) {
  std::map<std::string, std::size_t> providers;
  for (std::size_t i = 0; i < thread.modules.size(); ++i) {
    for (const ModuleOutput* output : thread.modules[i].outputs)
      providers[output->representation->name()] = i;
  }
  std::vector<std::vector<Edge>> result(thread.modules.size());
  for (std::size_t i = 0; i < thread.modules.size(); ++i) {
    for (const ModuleInput& input : thread.modules[i].inputs) {
      const auto provider = providers.find(input.representation);
      if (input.kind == ModuleInput::Kind::used || provider == providers.end()) continue;
      result[i].push_back({provider->second, input.representation});
    }
  }
  return result;
}

/// The shortest cycle through a module: it, what it requires and so on back to it. Empty if there is none.
std::vector<Edge> shortestCycle(const std::vector<std::vector<Edge>>& edges, std::size_t start) {
  std::vector<std::vector<Edge>> way(edges.size());  // from start to each module
  std::deque<std::size_t> queue{start};
  while (!queue.empty()) {
    const std::size_t at = queue.front();
    queue.pop_front();
    for (const Edge& edge : edges[at]) {
      if (edge.from != start && !way[edge.from].empty()) continue;
      std::vector<Edge> path = way[at];
      path.push_back(edge);
      if (edge.from == start) return path;
      way[edge.from] = std::move(path);
      queue.push_back(edge.from);
    }
  }
  return {};
}

}  // namespace

void sortModules(ThreadPlan& thread) {
  const std::size_t count = thread.modules.size();
  const auto before = edges(thread);
  std::vector<std::vector<std::size_t>> after(count);
  std::vector<std::size_t> missing(count);
  std::set<std::size_t> ready;
  for (std::size_t i = 0; i < count; ++i) {
    missing[i] = before[i].size();
    for (const Edge& edge : before[i]) after[edge.from].push_back(i);
    if (missing[i] == 0) ready.insert(i);
  }
  std::vector<ModulePlan> sorted;
  while (!ready.empty()) {
    const std::size_t next = *ready.begin();
    ready.erase(ready.begin());
    sorted.push_back(thread.modules[next]);
    for (const std::size_t i : after[next]) {
      if (--missing[i] == 0) ready.insert(i);
    }
  }
  if (sorted.size() == count) {
    thread.modules = std::move(sorted);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto cycle = shortestCycle(before, i);
    if (cycle.empty()) continue;
    const auto name = [&](std::size_t module) { return thread.modules[module].loader->description().name; };
    std::string text = name(i);
    for (const Edge& edge : cycle) text += " requires " + edge.representation + " of " + name(edge.from);
    throw ConfigurationError(thread.modules[i].path + ":" + std::to_string(thread.modules[i].line) +
                             ": cycle in thread " + thread.name + ": " + text + "; one of them must be USES");
  }
}

}  // namespace plumbline
