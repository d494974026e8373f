#pragma once
#include <cstdint>
#include <string>

#include "representations/infrastructure/PlayerInfo.h"

namespace plumbline {

class OutputProblems;

/// A player's own file, FOLDER/left-5.csv: a line with the names of the columns, then whole lines. Where the
/// disk takes no more it ends with the last whole one; that is said once, and the player plays on.
class PlayerFile {
public:
  /// `what`: what is in it, for the message, as "the decisions".
  PlayerFile(std::string what, std::string columns);
  ~PlayerFile();
  PlayerFile(const PlayerFile&) = delete;
  PlayerFile& operator=(const PlayerFile&) = delete;

  /// Before anything is written: makes the folder. Throws std::runtime_error, one line, where the file of a
  /// player cannot be: side and number are not known then, so each one that is there must be writable.
  static void prepare(const std::string& folder);

  /// Whole at once, as the agent may be ended at any time; each of `lines` has its end. The first call begins
  /// the file.
  void write(const std::string& folder, const PlayerInfo& player, const std::string& lines,
             OutputProblems& problems);

private:
  void append(const std::string& text);
  void cutOff();
  void close();

  std::string what_, columns_, path_;
  int fd_ = -1;
  std::int64_t size_ = 0;  ///< of the whole lines [bytes]
  bool ended_ = false;
};

}  // namespace plumbline
