#pragma once
#include <ios>
#include <optional>
#include <string>
#include <vector>

#include "game/RunLines.h"

namespace plumbline::game {

/// Follows an agent's output file and keeps what its status lines say ("status T robot X Y DEG ball X Y
/// WORDS", see StatusReport).
class StatusReader {
public:
  explicit StatusReader(std::string path) : path_(std::move(path)) {}
  /// Reads what was added since the last call; returns all so far, in the order of the file.
  const std::vector<StatusWords>& read();

private:
  std::string path_;
  std::streamoff position_ = 0;
  std::vector<StatusWords> said_;
};

/// Time and words of a status line, or nothing if it is another line.
std::optional<StatusWords> statusOf(const std::string& line);

}  // namespace plumbline::game
