#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

struct gzFile_s;

namespace plumbline::gap {

/// The entries of a file that holds one JSON list, plain or packed by gzip, one after the other. No entry is
/// longer than a bound, so that a long recording needs little memory. Its words are those of TextLines.
class JsonArray {
public:
  /// Whether a file begins with a list.
  static bool isIn(const std::string& path);

  /// Throws TextError: the file cannot be read.
  JsonArray(std::string path, std::size_t maxLength);

  /// The text of the next entry, valid until the one after it; false behind the last. Throws TextError.
  bool next(std::string_view& text);

  /// In which the last entry begins.
  std::size_t line() const { return line_; }
  const std::string& path() const { return path_; }
  [[noreturn]] void fail(const std::string& what) const;

private:
  int take();
  int takeVisible();
  void takeEntry(int first);

  std::string path_, entry_;
  std::size_t maxLength_, line_ = 1, lineNow_ = 1;
  std::unique_ptr<gzFile_s, int (*)(gzFile_s*)> file_;
  bool begun_ = false, ended_ = false;
};

}  // namespace plumbline::gap
