#pragma once
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "web/MatchFile.h"

namespace plumbline::web {

/// The state of the game in a record. Throws std::runtime_error "FILE: the game's state at 6.00 s
/// ...".
nlohmann::json gameOf(const MatchRecord& record, const std::string& file);

/// Finds the goals of a recorded match, chunk by chunk, so that its reader is not held up.
class GoalMarks {
public:
  struct Goal {
    double time = 0;  ///< since the start of the recording [s]
    bool left = true;
  };

  /// The records of the next chunk, in the order of the file.
  void add(const std::vector<MatchRecord>& records, const std::string& file);
  const std::vector<Goal>& goals() const { return found_; }

private:
  struct Score {
    double left = 0, right = 0;
  };
  std::optional<Score> last_;
  std::vector<Goal> found_;
};

}  // namespace plumbline::web
