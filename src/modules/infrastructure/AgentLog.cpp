#include "modules/infrastructure/AgentLog.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "framework/CommandLine.h"
#include "framework/ConfigFile.h"
#include "framework/ConfigurationError.h"
#include "framework/Controller.h"
#include "framework/ModuleParameters.h"
#include "framework/NearestName.h"
#include "framework/ParameterFiles.h"
#include "record/ReplayConfig.h"

namespace plumbline {

MAKE_PARAMETER_FILE("log", LogParameters, "What `bin/agent --log` keeps.")

namespace {

constexpr const char* configName = "log";
constexpr std::uint64_t megabyte = 1'000'000;

LogParameters readLogParameters(const std::vector<std::string>& directories) {
  LogParameters parameters;
  ConfigStore store(directories);
  if (!store.exists(configName)) return parameters;
  const ConfigFile& file = store.file(configName);
  readParameters(file.root(), LogParameters::parameterList(), &parameters);
  file.checkUnknown();
  return parameters;
}

/// Throws for a name that no thread has.
void checkNames(const std::vector<std::string>& names, const Controller& controller) {
  std::vector<std::string> known;
  for (const ThreadPlan& thread : controller.threads()) {
    for (const CopyPlan& copy : thread.copies) known.push_back(copy.representation->name());
    for (const SpecialPlan& special : thread.specials)
      for (const auto* loader : special.representations) known.push_back(loader->name());
    for (const ModulePlan& module : thread.modules)
      for (const ModuleOutput* output : module.outputs) known.push_back(output->representation->name());
  }
  for (const std::string& name : names)
    if (std::ranges::find(known, name) == known.end())
      throw ConfigurationError("log: this agent has no representation " + name + suggestion(name, known));
}

}  // namespace

void declareLogOptions(CommandLine& app, AgentLogOptions& options) {
  const CommandOption log = app.option(
      "--log", options.folder, "record into this new folder, a bag for ROS 2's tools and bin/logtool");
  app.option("--log-only", options.only, "with --log: these representations, by commas; default: all")
      .byCommas()
      .needs(log);
  app.flag("--log-wait", options.waits,
           "with --log: hold the agent up rather than drop a cycle, for a simulator that waits")
      .needs(log);
  const CommandOption replay =
      app.option("--replay", options.replay, "run on this log instead of the platform");
  app.option("--compute", options.compute,
             "with --replay: the modules that run, by commas; the log has what the others provided; default: "
             "all but the platform's")
      .byCommas()
      .needs(replay);
  app.option("--replay-speed", options.replayed.speed,
             "with --replay: 1 is the pace of the recording, 0 as fast as it goes")
      .range(0.0, 1000.0)
      .needs(replay)
      .showDefault();
  app.flag("--paused", options.replayed.paused,
           "with --replay: begin paused and stay at the end; bin/rdb moves it, see `list replay:`")
      .needs(replay);
}

ModulesConfig modulesOnLog(ModulesConfig modules, const AgentLogOptions& options,
                           const std::string& platform) {
  try {
    const record::LogReader log(options.replay);
    return record::replayConfig(std::move(modules), log, options.compute, platform);
  } catch (const ConfigurationError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw ConfigurationError(error.what());
  }
}

std::shared_ptr<LogOptions> makeLog(const AgentLogOptions& options, const Controller& controller,
                                    const std::vector<std::string>& configDirectories,
                                    std::function<void(const std::string&)> notify) {
  auto made = std::make_shared<LogOptions>();
  made->notify = notify;
  const LogParameters parameters = readLogParameters(configDirectories);
  made->representations = options.only.empty() ? parameters.representations : options.only;
  if (options.records()) checkNames(made->representations, controller);
  if (options.replays())
    made->replay = std::make_shared<record::ReplayControl>(options.replay, options.replayed);
  if (!options.records()) return made;
  record::RecorderOptions recorder;
  recorder.writer.fileBytes = megabyte * static_cast<std::uint64_t>(parameters.fileMegabytes);
  recorder.writer.files = static_cast<std::size_t>(parameters.files);
  recorder.bufferBytes = megabyte * static_cast<std::size_t>(parameters.bufferMegabytes);
  recorder.waits = options.waits || options.replays();  // nobody waits for a replay
  try {
    made->recorder = std::make_shared<record::Recorder>(options.folder, recorder, std::move(notify));
  } catch (const std::runtime_error& error) {
    throw ConfigurationError(error.what());
  }
  return made;
}

}  // namespace plumbline
