#pragma once
#include <string>

#include "parameters/Parameter.h"
#include "simspark/LeagueRobots.h"

namespace plumbline {

/// The robot of a trial and what its world is.
struct RobotOptions {
  PARAMETERS(RobotOptions)
  PARAMETER(int, type, 0, "", Range(0, maxSimsparkTypes - 1), "the league's type of robot")
  PARAMETER(std::string, engine, "ode", "", Range(),
            "physics engine: ode (the league's), bullet or another one that there is")
  PARAMETER(std::string, effects, "", "", Range(),
            "file of effects that the worlds have, or an answer of bin/gap diagnose "
            "(doc/reference/effects-file.md)")
};

/// Options of all tasks that play motions.
struct WorldOptions {
  PARAMETERS(WorldOptions)
  PARAMETER_GROUP(RobotOptions, robot, "robot and what its worlds are")
  PARAMETER(int, draws, 0, "", Range(0, 64),
            "number of worlds, each with other effects of the file; 0: one with all of them")
  PARAMETER(int, firstDraw, 0, "", Range(0, 1e6),
            "draw to begin with; 1 and later ones are worlds that a search without this option has not seen")
};

}  // namespace plumbline
