#pragma once
#include <string>

namespace plumbline::web {

/// The files of bin/agent --decisions in a folder as JSON for the page of a summary:
/// [{"side":"left","unum":5,"lines":[[clock,x,y,[[action,endX,endY,value,goal],...]],...]}]. The clock is the
/// game's [s]. Places are on the field as the page shows it [m]: those of the right team are turned, as its
/// files have them in the team's frame. The first action is the chosen one. Other files are overlooked, and
/// so is a last line that was cut off. Throws std::runtime_error, one line, for a folder without such files,
/// for a file of more than 8 MiB and, with its place, for a line that is none of DecisionRecorder's.
std::string gameDecisions(const std::string& folder);

}  // namespace plumbline::web
