// How an Inspector shows what the agent is made of: threads, modules, parameters.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "inspect/Inspector.h"

namespace plumbline::inspect {
namespace {

using nlohmann::ordered_json;

std::string text(const ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

double tenths(double value) { return std::round(10 * value) / 10; }

std::string threadText(const ThreadReport& thread) {
  std::string line =
      fmt::format("[{}] load {:.1f} %, {:.1f} us a cycle", thread.name, 100 * thread.load, thread.time);
  if (thread.rate > 0)
    line += fmt::format(", at {:g} Hz {} of {} cycles ran over", thread.rate, thread.overruns, thread.cycles);
  return line;
}

std::string threadJson(const ThreadReport& thread) {
  ordered_json copies = ordered_json::array();
  for (const auto& copy : thread.copies)
    copies.push_back({{"thread", copy.thread}, {"representation", copy.representation}});
  return text({{"thread", thread.name},
               {"load", tenths(100 * thread.load) / 100},
               {"us", tenths(thread.time)},
               {"rate", thread.rate},
               {"cycles", thread.cycles},
               {"overruns", thread.overruns},
               {"copies", copies}});
}

std::string moduleText(const ModuleReport& module) {
  const std::string wait = module.wait >= 0.05 ? fmt::format(" + {:.1f} us waiting", module.wait) : "";
  const std::string over =
      module.overruns > 0 ? fmt::format(", longest in {} that ran over", module.overruns) : "";
  std::string line = fmt::format("  {} ({:.1f} us{}{})", module.name, module.time, wait, over);
  if (!module.provides.empty()) line += fmt::format(": {}", fmt::join(module.provides, ", "));
  if (!module.reads.empty()) line += fmt::format(" <- {}", fmt::join(module.reads, ", "));
  return line;
}

std::string moduleJson(const ThreadReport& thread, const ModuleReport& module) {
  return text({{"module", module.name},
               {"of", thread.name},
               {"area", module.area},
               {"us", tenths(module.time)},
               {"waits", tenths(module.wait)},
               {"overruns", module.overruns},
               {"provides", module.provides},
               {"reads", module.reads},
               {"uses", module.uses}});
}

std::string parameterText(const std::string& id, const AgentDebug::ParameterInfo& info) {
  const Parameter& parameter = *info.parameter;
  std::string line = id + "  " + info.type;
  if (!parameter.unit.empty()) line += ", " + parameter.unit;
  if (std::isfinite(parameter.range.min) || std::isfinite(parameter.range.max))
    line += fmt::format(", {:g} .. {:g}", parameter.range.min, parameter.range.max);
  if (!parameter.words.empty()) line += fmt::format(", one of {}", fmt::join(parameter.words, ", "));
  return line + ": " + parameter.comment;
}

std::string parameterJson(const std::string& id, const AgentDebug::ParameterInfo& info) {
  const Parameter& parameter = *info.parameter;
  const auto bound = [](double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(); };
  return text({{"id", id},
               {"type", info.type},
               {"unit", parameter.unit},
               {"min", bound(parameter.range.min)},
               {"max", bound(parameter.range.max)},
               {"words", parameter.words},
               {"default", parameter.defaultText},
               {"comment", parameter.comment}});
}

}  // namespace

void Inspector::graph(int client, const Command& command) {
  const bool json = clients_[client].json;
  for (const ThreadReport& thread : agent_.graph()) {
    line(client, command.tag, json ? threadJson(thread) : threadText(thread));
    for (const ModuleReport& module : thread.modules)
      line(client, command.tag, json ? moduleJson(thread, module) : moduleText(module));
  }
  finish(client, command.tag);
}

void Inspector::about(int client, const Command& command) {
  const bool json = clients_[client].json;
  for (const auto& [id, info] : agent_.parameters()) {
    if (!id.starts_with(command.name)) continue;
    line(client, command.tag, json ? parameterJson(id, info) : parameterText(id, info));
  }
  finish(client, command.tag);
}

}  // namespace plumbline::inspect
