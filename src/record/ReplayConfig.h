#pragma once
#include <string>
#include <vector>

#include "framework/ModulesConfig.h"
#include "record/LogReader.h"

namespace plumbline::record {

/// Changes a modules.cfg so that it runs on a log: representations of modules that do not run, of other
/// threads or from outside come from the special module `log`. The modules of `compute` run; if that is
/// empty, all run except those in the folder of `platform`. Modules that provide nothing run too. The order
/// is that of the recording. Throws ConfigurationError for unknown names and for representations that neither
/// the log nor a module provides.
ModulesConfig replayConfig(ModulesConfig modules, const LogReader& log,
                           const std::vector<std::string>& compute, const std::string& platform);

}  // namespace plumbline::record
