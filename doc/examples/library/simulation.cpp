// A robot of the league's type 0 that stands in a world of its own for a second. Its argument is the folder
// of the configuration, in which the robots are: PREFIX/share/plumbline/config.
#include <cstdio>

#include "framework/ConfigFolder.h"
#include "simspark/LeagueRobots.h"
#include "simulation/league/LocalRobot.h"

int main(int argc, char** argv) {
  if (argc > 1) plumbline::useConfigFolder(argv[1]);
  plumbline::simulation::LocalRobot robot(plumbline::simsparkRobot(0));
  robot.restart();
  while (robot.time() < 1) robot.act({});
  std::printf("after %.1f s it %s\n", robot.time(), robot.fallen() ? "has fallen" : "stands");
}
