#pragma once
#include <fstream>
#include <string>

#include "representations/infrastructure/PlayerInfo.h"

namespace plumbline {

/// Opens a player's own file, FOLDER/left-5.csv, and writes the line with the names of the columns. A file
/// that is open stays as it is. Throws std::runtime_error, one line, if it cannot be written.
void openPlayerFile(std::ofstream& out, const std::string& folder, const PlayerInfo& player,
                    const std::string& columns);

}  // namespace plumbline
