#pragma once
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

struct gzFile_s;

namespace plumbline {

/// What is wrong with a text file: one line, "file:line: what" or "file: what".
class TextError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// The lines of a text file, plain or packed by gzip, one after the other. No line is longer than a bound, so
/// that a file of another kind cannot take all memory.
class TextLines {
public:
  static constexpr std::size_t usualLength = 1 << 17;  ///< of the longest line, its end included [characters]

  /// Throws TextError: the file cannot be read. `advice` follows then, as "; give a trace as .csv".
  explicit TextLines(std::string path, std::size_t maxLength = usualLength, const std::string& advice = "");

  /// The next line without its end, valid until the one after it; false behind the last. Throws TextError: a
  /// line too long, a NUL character, a packed file that is damaged or cut short.
  bool next(std::string_view& text);

  /// Of the last line, from 1; 0 before the first.
  std::size_t line() const { return line_; }
  const std::string& path() const { return path_; }
  /// Throws TextError with the place of the last line before what is wrong there.
  [[noreturn]] void fail(const std::string& what) const;

private:
  std::string path_, buffer_;
  std::unique_ptr<gzFile_s, int (*)(gzFile_s*)> file_;
  long at_ = 0;  ///< where the next line begins in the unpacked text
  std::size_t line_ = 0;
};

}  // namespace plumbline
