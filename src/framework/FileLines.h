#pragma once
#include <fstream>
#include <string>

namespace plumbline {

/// The lines of a file, one after the other. Where a stream alone takes a lack of memory or a broken disk for
/// the end of the file, this throws.
class FileLines {
public:
  /// From a byte on that begins a line. Throws std::runtime_error, "FILE: cannot be read: REASON".
  explicit FileLines(std::string path, std::streamoff from = 0);

  /// The next line without its end; false behind the last. Throws the same, and std::bad_alloc.
  bool next(std::string& line);
  /// Whether the last line had an end; one without may still be in the making.
  bool whole() const { return !file_.eof(); }
  /// Where the next line begins [bytes].
  std::streamoff end() const { return end_; }

private:
  [[noreturn]] void fail() const;

  std::string path_;
  std::ifstream file_;
  std::streamoff end_ = 0;
};

}  // namespace plumbline
