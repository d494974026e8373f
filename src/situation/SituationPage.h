#pragma once
#include <string>
#include <vector>

#include "field/FieldSize.h"
#include "situation/Situation.h"

namespace plumbline {

/// The situations of a folder and of those in it, in the order of kinds and names.
struct SituationEntry {
  std::string file;  ///< as the folder was named
  std::string name;  ///< of its picture, without an ending: those of the folders and its own
  Situation situation;
};

/// Throws ConfigurationError as readSituation does, and std::runtime_error for a folder that has none.
std::vector<SituationEntry> situationsIn(const std::string& folder);

/// A page in Markdown that shows all of them: picture (`pictures` is the folder as the page links it), what
/// it is about, and the decision that people expect. `command` made it.
std::string situationPage(const std::vector<SituationEntry>& entries, const std::string& pictures,
                          const std::string& command);

}  // namespace plumbline
