#pragma once
#include <string>
#include <vector>

#include "framework/ModuleDescription.h"

namespace plumbline {

class ConfigSection;
class ConfigStore;

/// Reads the parameters of `owner` that a map of a configuration file names; the others keep their values.
void readParameters(const ConfigSection& section, const ParameterList& parameters, void* owner);

/// Reads a module's parameters from its configuration file, if it has one, and calls its parametersChanged().
/// Throws ConfigurationError naming file, line and key.
void configureModule(Module& module, const ModuleDescription& description, ConfigStore& store);

/// A parameter's value as text. Throws ConfigurationError for an unknown path, with the nearest one.
std::string moduleParameter(const Module& module, const ModuleDescription& description,
                            const std::string& path);

/// Sets a parameter of a running module from text as it would be in the module's file, between two
/// executions. Throws ConfigurationError "Module.path must be ..." and leaves the old value if the text is no
/// value of the parameter, out of its range, or refused by the module.
void setModuleParameter(Module& module, const ModuleDescription& description, const std::string& path,
                        const std::string& text);

}  // namespace plumbline
