#pragma once
#include <string>
#include <vector>

namespace plumbline::rdb {

/// What was typed, oldest first; kept in a file from one use to the next.
class History {
public:
  static constexpr std::size_t most = 1000;
  /// `path` empty: not kept.
  explicit History(std::string path);
  /// In the folder for state that XDG names: ~/.local/state/plumbline/rdb_history; "" if there is none.
  static std::string standardPath();

  void add(const std::string& line);
  const std::vector<std::string>& lines() const { return lines_; }
  /// Adds what was typed here to what the file holds now: another console may have saved meanwhile. Returns
  /// "" or why it could not be written.
  std::string save() const;

private:
  std::string path_;
  std::vector<std::string> lines_, typed_;
};

}  // namespace plumbline::rdb
