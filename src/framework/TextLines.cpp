#include "framework/TextLines.h"

#include <zlib.h>

#include <utility>

namespace plumbline {

TextLines::TextLines(std::string path, std::size_t maxLength, const std::string& advice)
    : path_(std::move(path)), buffer(maxLength, '\0'), file(gzopen(path_.c_str(), "rb"), gzclose) {
  if (!file) throw TextError(path_ + ": cannot be read" + advice);
  gzbuffer(file.get(), 1 << 16);
}

bool TextLines::next(std::string_view& text) {
  if (!gzgets(file.get(), buffer.data(), static_cast<int>(buffer.size()))) {
    int code = Z_OK;
    gzerror(file.get(), &code);
    if (code == Z_BUF_ERROR) fail("the file is cut short");
    if (code != Z_OK) fail("cannot be unpacked; the file is damaged");
    return false;
  }
  ++line_;
  text = buffer.data();
  const long end = gztell(file.get());
  if (end - at != static_cast<long>(text.size())) fail("holds a NUL character; the file is damaged");
  at = end;
  if (text.size() + 1 == buffer.size() && text.back() != '\n')
    fail("the line is longer than " + std::to_string(buffer.size()) + " characters");
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  return true;
}

void TextLines::fail(const std::string& what) const {
  throw TextError(path_ + ":" + std::to_string(line_) + ": " + what);
}

}  // namespace plumbline
