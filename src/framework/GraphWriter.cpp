#include "framework/GraphWriter.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "framework/ConfigurationError.h"

extern char** environ;

namespace plumbline {
namespace {

std::string id(const std::string& thread, const std::string& kind, const std::string& name) {
  return '"' + thread + "/" + kind + "/" + name + '"';
}

void writeThread(std::string& text, const ThreadPlan& thread) {
  const auto representation = [&](const std::string& name) {
    return id(thread.name, "representation", name);
  };
  text += "  subgraph \"cluster_" + thread.name + "\" {\n    label=\"" + thread.name + "\";\n";
  const auto addRepresentation = [&](const std::string& name) {
    text += "    " + representation(name) + " [label=\"" + name + "\", shape=ellipse];\n";
  };
  for (const CopyPlan& copy : thread.copies) addRepresentation(copy.representation->name());
  for (const SpecialPlan& special : thread.specials) {
    const std::string module = id(thread.name, "module", special.name);
    text += "    " + module + " [label=\"" + special.name + "\", shape=box, style=rounded];\n";
    for (const auto* loader : special.representations) {
      addRepresentation(loader->name());
      text += "    " + module + " -> " + representation(loader->name()) + ";\n";
    }
  }
  for (const ModulePlan& plan : thread.modules) {
    const ModuleDescription& description = plan.loader->description();
    const std::string module = id(thread.name, "module", description.name);
    text += "    " + module + " [label=\"" + description.name + "\", shape=box];\n";
    for (const ModuleOutput* output : plan.outputs) {
      addRepresentation(output->representation->name());
      text += "    " + module + " -> " + representation(output->representation->name()) + ";\n";
    }
    for (const ModuleInput& input : description.inputs) {
      const std::string& name = input.representation->name();
      if (thread.provider(name).empty()) continue;
      text += "    " + representation(name) + " -> " + module;
      if (input.kind == ModuleInput::Kind::requiredIfProvided) text += " [color=gray50]";
      if (input.kind == ModuleInput::Kind::used) text += " [style=dashed, constraint=false]";
      text += ";\n";
    }
  }
  text += "  }\n";
}

/// Returns what went wrong or an empty string.
std::string writeFile(const std::string& path, const std::string& text) {
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  return stream ? "" : std::strerror(errno);
}

/// Runs `dot -Tformat input -o output`; returns what went wrong or an empty string.
std::string runDot(const std::string& format, const std::string& input, const std::string& output) {
  std::string type = "-T" + format, program = "dot", option = "-o";
  std::string in = input, out = output;
  char* arguments[] = {program.data(), type.data(), in.data(), option.data(), out.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, "dot", nullptr, nullptr, arguments, environ);
  if (error == ENOENT)
    return "Graphviz's program dot is not installed; install graphviz or write a .dot file";
  if (error != 0) return std::string("dot cannot be started: ") + std::strerror(error);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? "" : "dot failed";
}

}  // namespace

std::string graphText(const std::vector<ThreadPlan>& threads) {
  std::string text = "digraph modules {\n  node [fontname=\"Helvetica\"];\n";
  for (const ThreadPlan& thread : threads) writeThread(text, thread);
  for (const ThreadPlan& thread : threads) {
    for (const CopyPlan& copy : thread.copies) {
      const std::string& name = copy.representation->name();
      text += "  " + id(copy.fromThread, "representation", name) + " -> " +
              id(thread.name, "representation", name) + " [style=dotted];\n";
    }
  }
  return text + "}\n";
}

void writeGraph(const std::vector<ThreadPlan>& threads, const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension != ".dot" && extension != ".svg" && extension != ".pdf" && extension != ".png") {
    throw ConfigurationError(path + ": a graph is written as .dot, .svg, .pdf or .png");
  }
  // Written beside and moved, so that there is never half a file.
  const std::string beside = path + ".part" + std::to_string(getpid());
  const std::string dotFile = beside + ".dot";
  std::string error = writeFile(dotFile, graphText(threads));
  if (error.empty() && extension == ".dot") {
    error = std::rename(dotFile.c_str(), path.c_str()) == 0 ? "" : std::strerror(errno);
  } else if (error.empty()) {
    error = runDot(extension.substr(1), dotFile, beside);
    if (error.empty() && std::rename(beside.c_str(), path.c_str()) != 0) error = std::strerror(errno);
  }
  std::remove(dotFile.c_str());
  std::remove(beside.c_str());
  if (!error.empty()) throw ConfigurationError(path + ": cannot be written: " + error);
}

}  // namespace plumbline
