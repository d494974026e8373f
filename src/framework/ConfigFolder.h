#pragma once
#include <string>

namespace plumbline {

/// The folder of the running program's file; "." where the system does not say.
std::string programFolder();

/// The folder of the configuration, for every program and from any folder. It is the one of `--config`
/// (useConfigFolder), else config/ in the current folder, else that of the program's installation: config/
/// next to its bin/, or share/plumbline/. A folder counts if it contains platforms/. If there is none, the
/// result is "config", so that errors name it. The path is relative if that is short.
std::string configFolder();

/// A file or folder in it.
std::string configPath(const std::string& name);

/// From now on configFolder() is this one. Throws ConfigurationError if there is no such folder. Call it
/// before threads begin.
void useConfigFolder(const std::string& folder);

}  // namespace plumbline
