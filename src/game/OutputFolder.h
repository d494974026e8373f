#pragma once
#include <string>
#include <vector>

namespace plumbline::game {

/// build/run of the project this program belongs to, wherever it is called from; as seen from the current
/// folder if that is inside the project.
std::string defaultOutput();

/// Makes the folder, removes these files of an earlier run, and tests whether it can be written. Throws
/// std::runtime_error "cannot write to FOLDER: REASON; give --output another folder".
void prepareOutput(const std::string& folder, const std::vector<std::string>& files);

}  // namespace plumbline::game
