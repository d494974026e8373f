#pragma once
#include <fstream>
#include <string>

namespace plumbline::game {

/// Follows an agent's output file and keeps the words of its last status line ("status T robot X Y DEG ball X
/// Y WORDS", see StatusReport).
class StatusReader {
public:
  explicit StatusReader(std::string path) : path_(std::move(path)) {}
  /// Reads what was added since the last call; returns the words, empty before the first line.
  const std::string& read();

private:
  std::string path_;
  std::streamoff position_ = 0;
  std::string words_;
};

/// The words of a status line, or empty if it is another line.
std::string wordsOfStatus(const std::string& line);

}  // namespace plumbline::game
