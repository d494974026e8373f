#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "framework/ModulesConfig.h"
#include "modules/infrastructure/LogOptions.h"

namespace plumbline {

class CommandLine;
class Controller;

/// What bin/agent's command line says of logs.
struct AgentLogOptions {
  std::string folder, replay;
  std::vector<std::string> only, compute;
  record::LogReplayOptions replayed;
  bool waits = false;  ///< rather than to drop a cycle

  bool records() const { return !folder.empty(); }
  bool replays() const { return !replay.empty(); }
};

void declareLogOptions(CommandLine& app, AgentLogOptions& options);

/// The modules.cfg with the log in the place of the modules that do not run (record/ReplayConfig.h). Throws
/// ConfigurationError.
ModulesConfig modulesOnLog(ModulesConfig modules, const AgentLogOptions& options,
                           const std::string& platform);

/// For the modules of the agent, before its init(): opens what is recorded and replayed, with what
/// config/log.yaml says. Throws ConfigurationError.
std::shared_ptr<LogOptions> makeLog(const AgentLogOptions& options, const Controller& controller,
                                    const std::vector<std::string>& configDirectories,
                                    std::function<void(const std::string&)> notify);

}  // namespace plumbline
