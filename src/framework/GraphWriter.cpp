#include "framework/GraphWriter.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "framework/ConfigurationError.h"
#include "framework/RunDot.h"

namespace plumbline {
namespace {

std::string id(const std::string& thread, const std::string& kind, const std::string& name) {
  return '"' + thread + "/" + kind + "/" + name + '"';
}

/// Pale enough for black words, apart for most eyes; areas take them in the order in which they come.
constexpr std::array<const char*, 9> palette = {"#cfe2f3", "#d9ead3", "#fff2cc", "#f4cccc", "#d9d2e9",
                                                "#fce5cd", "#d0e0e3", "#ead1dc", "#e3e3d0"};

/// Nodes of one thread in frames of their areas, and the lines between them.
class ThreadGraph {
public:
  ThreadGraph(const ThreadPlan& thread, const ModuleTimes& times) : thread_(thread), times_(times) {}

  std::string text() {
    for (const CopyPlan& copy : thread_.copies) addRepresentation("", copy.representation->name());
    for (const SpecialPlan& special : thread_.specials) {
      const std::string module = addModule("", special.name, ", style=rounded");
      for (const auto* loader : special.representations) provide("", module, loader->name());
    }
    for (const ModulePlan& plan : thread_.modules) add(plan);
    std::string text = "  subgraph \"cluster_" + thread_.name + "\" {\n    label=\"" + thread_.name + "\";\n";
    for (std::size_t i = 0; i < areas_.size(); ++i) {
      const auto& [area, nodes] = areas_[i];
      if (area.empty()) {
        text += nodes;
        continue;
      }
      text += "    subgraph \"cluster_" + thread_.name + "/" + area + "\" {\n    label=\"" + area +
              "\"; labelloc=t; fontsize=24; style=\"filled,rounded\"; color=\"" +
              palette[i % palette.size()] + "\";\n" + nodes + "    }\n";
    }
    return text + lines_ + "  }\n";
  }

private:
  std::string& nodesOf(const std::string& area) {
    for (auto& [name, nodes] : areas_)
      if (name == area) return nodes;
    return areas_.emplace_back(area, "").second;
  }

  std::string representation(const std::string& name) const {
    return id(thread_.name, "representation", name);
  }

  void addRepresentation(const std::string& area, const std::string& name) {
    nodesOf(area) += "    " + representation(name) + " [label=\"" + name + "\", shape=ellipse];\n";
  }

  std::string addModule(const std::string& area, const std::string& name, const std::string& style) {
    std::string module = id(thread_.name, "module", name);
    std::string label = name;
    if (const auto time = times_.find(name); time != times_.end()) {
      char text[32];
      std::snprintf(text, sizeof text, "\\n%.1f us", time->second);
      label += text;
    }
    nodesOf(area) += "    " + module + " [label=\"" + label + "\", shape=box" + style + "];\n";
    return module;
  }

  void provide(const std::string& area, const std::string& module, const std::string& name) {
    addRepresentation(area, name);
    lines_ += "    " + module + " -> " + representation(name) + ";\n";
  }

  void add(const ModulePlan& plan) {
    const ModuleDescription& description = plan.loader->description();
    const std::string area = description.area();
    const std::string module =
        addModule(area, description.name, area.empty() ? "" : ", style=filled, fillcolor=white");
    for (const ModuleOutput* output : plan.outputs) provide(area, module, output->representation->name());
    for (const ModuleInput& input : plan.inputs) {
      const std::string& name = input.representation;
      if (thread_.provider(name).empty()) continue;
      lines_ += "    " + representation(name) + " -> " + module;
      if (input.kind == ModuleInput::Kind::requiredIfProvided) lines_ += " [color=gray50]";
      if (input.kind == ModuleInput::Kind::used) lines_ += " [style=dashed, constraint=false]";
      lines_ += ";\n";
    }
  }

  const ThreadPlan& thread_;
  const ModuleTimes& times_;
  std::vector<std::pair<std::string, std::string>> areas_;  ///< name and nodes, in the order of the modules
  std::string lines_;
};

constexpr const char* legend =
    "  labelloc=b;\n  label=\"box: module    ellipse: representation    full line: REQUIRES, PROVIDES    "
    "grey: REQUIRES_IF_PROVIDED    dashed: USES    dotted: copy between threads";
constexpr const char* timesLegend = "    us: mean time in a cycle, waiting included";

/// Returns what went wrong or an empty string.
std::string writeFile(const std::string& path, const std::string& text) {
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  return stream ? "" : std::strerror(errno);
}

constexpr double longestDrawing = 60;  // Graphviz takes a second or two [s]

/// A file that is gone at the end.
class PassingFile {
public:
  explicit PassingFile(std::string path) : path(std::move(path)) {}
  ~PassingFile() { std::remove(path.c_str()); }
  PassingFile(const PassingFile&) = delete;
  PassingFile& operator=(const PassingFile&) = delete;
  const std::string path;
};

}  // namespace

std::string graphText(const std::vector<ThreadPlan>& threads, const ModuleTimes& times) {
  std::string text =
      "digraph modules {\n  node [fontname=\"Helvetica\"];\n  graph [fontname=\"Helvetica\", rankdir=LR, "
      "ranksep=0.4, nodesep=0.12];\n";
  text += legend + std::string(times.empty() ? "" : timesLegend) + "\";\n";
  for (const ThreadPlan& thread : threads) text += ThreadGraph(thread, times).text();
  for (const ThreadPlan& thread : threads) {
    for (const CopyPlan& copy : thread.copies) {
      const std::string& name = copy.representation->name();
      text += "  " + id(copy.fromThread, "representation", name) + " -> " +
              id(thread.name, "representation", name) + " [style=dotted];\n";
    }
  }
  return text + "}\n";
}

void writeGraph(const std::vector<ThreadPlan>& threads, const std::string& path, const ModuleTimes& times) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension != ".dot" && extension != ".svg" && extension != ".pdf" && extension != ".png") {
    throw ConfigurationError(path + ": a graph is written as .dot, .svg, .pdf or .png");
  }
  // Written to another file and moved, so that there is never half a file.
  const PassingFile partial(path + ".part" + std::to_string(getpid())), dotFile(partial.path + ".dot");
  std::string error = writeFile(dotFile.path, graphText(threads, times));
  if (error.empty() && extension == ".dot") {
    error = std::rename(dotFile.path.c_str(), path.c_str()) == 0 ? "" : std::strerror(errno);
  } else if (error.empty()) {
    error = runDot(extension.substr(1), dotFile.path, partial.path, longestDrawing);
    if (error.empty() && std::rename(partial.path.c_str(), path.c_str()) != 0) error = std::strerror(errno);
  }
  if (!error.empty()) throw ConfigurationError(path + ": cannot be written: " + error);
}

}  // namespace plumbline
