#include "fuzz/Targets.h"

namespace plumbline::fuzz {

const std::vector<Target>& targets() {
  static const std::vector<Target> all = {
      {"agentMessage", agentMessage, agentSeeds, 40000},
      {"trainerMessage", trainerMessage, trainerSeeds, 40000},
      {"serverMessage", serverMessage, serverSeeds, 20000},
      {"monitorScene", monitorScene, sceneSeeds, 6000},
      {"framing", framing, frameSeeds, 40000},
      {"fieldMessage", fieldMessage, fieldSeeds, 40000},
      {"roboViz", roboViz, roboVizSeeds, 30000},
      {"matchFile", matchFile, matchSeeds, 6000},
      {"pageCommand", pageCommand, pageSeeds, 40000},
      {"robotFile", robotFile, robotSeeds, 1200},
      {"urdfFile", urdfFile, urdfSeeds, 2000},
      {"gapRun", gapRun, runSeeds, 2000},
      {"session", session, sessionSeeds, 400},
  };
  return all;
}

}  // namespace plumbline::fuzz
