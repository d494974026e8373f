#include "framework/TextLines.h"

#include <zlib.h>

#include <utility>

namespace plumbline {

TextLines::TextLines(std::string path, std::size_t maxLength, const std::string& advice)
    : path_(std::move(path)), buffer_(maxLength, '\0'), file_(gzopen(path_.c_str(), "rb"), gzclose) {
  if (!file_) throw TextError(path_ + ": cannot be read" + advice);
  gzbuffer(file_.get(), 1 << 16);
}

bool TextLines::next(std::string_view& text) {
  if (!gzgets(file_.get(), buffer_.data(), static_cast<int>(buffer_.size()))) {
    int code = Z_OK;
    gzerror(file_.get(), &code);
    if (code == Z_BUF_ERROR) fail("the file is cut short");
    if (code != Z_OK) fail("cannot be unpacked; the file is damaged");
    return false;
  }
  ++line_;
  text = buffer_.data();
  const long end = gztell(file_.get());
  if (end - at_ != static_cast<long>(text.size())) fail("holds a NUL character; the file is damaged");
  at_ = end;
  if (text.size() + 1 == buffer_.size() && text.back() != '\n')
    fail("the line is longer than " + std::to_string(buffer_.size()) + " characters");
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  return true;
}

void TextLines::fail(const std::string& what) const {
  throw TextError(path_ + ":" + std::to_string(line_) + ": " + what);
}

}  // namespace plumbline
