#pragma once
#include <string>

namespace plumbline {

/// The folder of the running program's file; "." where the system does not tell.
std::string programFolder();

/// The folder of the configuration, for every program and from any folder: the one named with `--config`
/// (useConfigFolder), else config/ in the current folder, else that of the installation the program belongs
/// to: config/ beside its bin/, or share/plumbline/. A folder counts if platforms/ is in it. "config" if
/// there is none, so that errors say what was looked for. The path is relative where that is short.
std::string configFolder();

/// A file or folder in it.
std::string configPath(const std::string& name);

/// From now on configFolder() is this one. Throws ConfigurationError if there is no such folder. Call it
/// before threads begin.
void useConfigFolder(const std::string& folder);

}  // namespace plumbline
