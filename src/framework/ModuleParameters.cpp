#include "framework/ModuleParameters.h"

#include <optional>
#include <stdexcept>

#include "framework/ConfigFile.h"
#include "framework/ConfigNode.h"
#include "framework/ConfigurationError.h"
#include "framework/Module.h"
#include "framework/NearestName.h"

namespace plumbline {
namespace {

void readNode(const ConfigNode& node, const Parameter& parameter, const ParameterPointer& pointer) {
  std::visit([&](auto* value) { readConfig(node, parameter.range, *value); }, pointer);
  if (const std::string fault = parameterFault(parameter, pointer); !fault.empty())
    throw ConfigurationError(node.place() + ": " + node.key + " " + fault);
}

struct Found {
  Parameter parameter;
  ParameterPointer pointer;
};

Found find(const Module& module, const ModuleDescription& description, const std::string& path) {
  std::optional<Found> found;
  // The list hands out pointers to change a value; the callers that only read take none.
  description.parameters.visit(
      const_cast<Module*>(&module),
      [&](const std::string& name, const Parameter& parameter, const ParameterPointer& pointer) {
        if (name == path) found = {parameter, pointer};
      });
  if (!found) {
    throw ConfigurationError("module " + description.name + " has no parameter " + path +
                             suggestion(path, description.parameters.paths()));
  }
  return *found;
}

}  // namespace

void readParameters(const ConfigSection& section, const ParameterList& parameters, void* owner) {
  parameters.visit(owner,
                   [&](const std::string& path, const Parameter& parameter, const ParameterPointer& pointer) {
                     if (const ConfigNode* node = section.node(path)) readNode(*node, parameter, pointer);
                   });
}

void configureModule(Module& module, const ModuleDescription& description, ConfigStore& store) {
  if (!description.parameters.empty() && store.exists(description.name))
    readParameters(store.file(description.name).root(), description.parameters, &module);
  module.parametersChanged();
}

std::string moduleParameter(const Module& module, const ModuleDescription& description,
                            const std::string& path) {
  return parameterText(find(module, description, path).pointer);
}

void setModuleParameter(Module& module, const ModuleDescription& description, const std::string& path,
                        const std::string& text) {
  const Found found = find(module, description, path);
  const std::string name = description.name + "." + path;
  const ConfigNode node = parseYamlValue(text, name);
  const ParameterValue before = parameterValue(found.pointer);
  try {
    std::visit([&](auto* value) { readConfig(node, found.parameter.range, *value); }, found.pointer);
    if (const std::string fault = parameterFault(found.parameter, found.pointer); !fault.empty())
      throw ConfigurationError(name + " " + fault);
    module.parametersChanged();
  } catch (const std::exception& error) {
    setParameterValue(found.pointer, before);
    module.parametersChanged();
    throw ConfigurationError(error.what());
  }
}

}  // namespace plumbline
