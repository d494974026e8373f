#pragma once
#include <string>
#include <vector>

#include "framework/ModulesConfig.h"
#include "record/LogReader.h"

namespace plumbline::record {

/// A modules.cfg that runs on a log: what a line got from a module that does not run now, from another thread
/// or from elsewhere, it gets from the special module `log`. Which modules run: those of `compute`, or, where
/// that is empty, all but those in the folder of `platform`; and besides all others that provide nothing.
/// They run in the order in which they ran when the log was written. Throws ConfigurationError for unknown
/// names and for what neither the log has nor a module provides.
ModulesConfig replayConfig(ModulesConfig modules, const LogReader& log,
                           const std::vector<std::string>& compute, const std::string& platform);

}  // namespace plumbline::record
