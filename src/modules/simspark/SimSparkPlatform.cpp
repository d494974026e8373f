#include "modules/simspark/SimSparkPlatform.h"

#include <algorithm>

#include "field/TeamSize.h"
#include "framework/ConfigurationError.h"
#include "robot/RobotModel.h"
#include "robot/RobotTypes.h"
#include "simspark/AgentCommand.h"
#include "simspark/LeagueRobots.h"

namespace plumbline {

MAKE_PLATFORM("simspark", SimSparkPlatform)

void SimSparkPlatform::declareOptions(CommandLine& app) {
  AgentOptions& agent = *options_;
  app.option("--team", agent.team, "team name").showDefault();
  app.option("--number", agent.number, "uniform number 1..11, 0: the next free one")
      .range(0, teamSize)
      .showDefault();
  app.option("--type", agent.type, "robot type: N of config/robots/simspark_typeN.json")
      .range(0, maxSimsparkTypes - 1)
      .showDefault();
  app.option("--token", agent.token, "token of the simulator, if its port is open to other machines");
  app.option("--host", agent.host, "host of the simulator").showDefault();
  app.option("--port", agent.port, "its agent port").port().showDefault();
  app.option("--monitor-port", agent.monitorPort, "its monitor port, for trainer commands")
      .port()
      .showDefault();
  app.flag("--start-simulator", agent.startSimulator,
           "start a simulator on free ports and restart it when it dies");
  app.option("--simulator-option", agent.simulatorOptions, "an option for that simulator; repeat for more")
      .oneValueEach();
}

void SimSparkPlatform::check() const {
  if (!simspark::isTeamName(options_->team))
    throw ConfigurationError("--team: a team's name is " + std::string(simspark::teamNameRule));
  const bool printable = std::all_of(options_->token.begin(), options_->token.end(),
                                     [](char c) { return c > ' ' && c <= '~' && c != '(' && c != ')'; });
  // An unknown type is reported before anything else starts.
  simsparkRobot(options_->type);
  if (!printable) throw ConfigurationError("--token has bytes that no token has");
}

std::vector<std::string> SimSparkPlatform::configFolders(const std::string& config) const {
  return {config + "/robots/" + simsparkRobotName(options_->type)};
}

void SimSparkPlatform::addObjects(ModuleObjects& objects,
                                  std::function<void(const std::string&)> notify) const {
  options_->notify = std::move(notify);
  objects.set(options_);
  objects.set(std::make_shared<RobotModel>(simsparkRobot(options_->type)));
  objects.set(std::make_shared<RobotTypes>(RobotTypes{simsparkRobotName}));
}

std::vector<NeededModule> SimSparkPlatform::neededModules() const {
  return {{"SimSparkConnection", "receives nothing from the simulator"},
          {"SimSparkSend", "sends nothing to the simulator"}};
}

std::string SimSparkPlatform::examples() const {
  return "  bin/agent --team Plumbline --number 1 --type 0           play on a server at port 3100\n"
         "  bin/agent --start-simulator --status                     start a simulator, too\n"
         "  bin/agent --start-simulator --simulator-option=--web --simulator-option=--realtime --motion "
         "wave\n"
         "                                                           see a motion on a page\n";
}

}  // namespace plumbline
