#include "gap/run/JsonArray.h"

#include <zlib.h>

#include <utility>

#include "framework/TextLines.h"

namespace plumbline::gap {
namespace {

bool isBlank(int c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

}  // namespace

bool JsonArray::isIn(const std::string& path) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile_s*)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file) return false;
  int c = gzgetc(file.get());
  for (const int mark : {0xef, 0xbb, 0xbf})  // byte order
    if (c == mark) c = gzgetc(file.get());
  while (isBlank(c)) c = gzgetc(file.get());
  return c == '[';
}

JsonArray::JsonArray(std::string path, std::size_t maxLength)
    : path_(std::move(path)), maxLength_(maxLength), file_(gzopen(path_.c_str(), "rb"), gzclose) {
  if (!file_) throw TextError(path_ + ": cannot be read");
  gzbuffer(file_.get(), 1 << 16);
}

bool JsonArray::next(std::string_view& text) {
  if (ended_) return false;
  int c = takeVisible();
  if (!begun_) {
    for (const int mark : {0xef, 0xbb, 0xbf})
      if (c == mark) c = takeVisible();
    if (c != '[') fail("is no list");
    begun_ = true;
    c = takeVisible();
  } else if (c == ',') {
    c = takeVisible();
  } else if (c != ']') {
    fail("broken JSON: a comma or ] is missing behind an entry");
  }
  line_ = lineNow_;
  if (c == ']') {
    ended_ = true;
    while (isBlank(c = gzgetc(file_.get()))) {
    }
    if (c >= 0) fail("goes on behind its list; give one list of objects");
    return false;
  }
  takeEntry(c);
  text = entry_;
  return true;
}

void JsonArray::takeEntry(int first) {
  entry_.assign(1, static_cast<char>(first));
  if (first != '{') fail("is no object; each entry is one: {\"t\": 0.01, ...}");
  bool quoted = false;
  for (std::size_t depth = 1; depth > 0;) {
    const int c = take();
    entry_ += static_cast<char>(c);
    if (entry_.size() > maxLength_)
      fail("the entry is longer than " + std::to_string(maxLength_) + " characters");
    if (quoted && c == '\\')
      entry_ += static_cast<char>(take());
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted && (c == '{' || c == '}'))
      c == '{' ? ++depth : --depth;
  }
}

int JsonArray::take() {
  const int c = gzgetc(file_.get());
  if (c < 0) {
    int code = Z_OK;
    gzerror(file_.get(), &code);
    if (code != Z_OK && code != Z_BUF_ERROR) fail("cannot be unpacked; the file is damaged");
    fail("the file is cut short: its list does not end");
  }
  lineNow_ += c == '\n';
  return c;
}

int JsonArray::takeVisible() {
  for (;;)
    if (const int c = take(); !isBlank(c)) return c;
}

void JsonArray::fail(const std::string& what) const {
  throw TextError(path_ + ":" + std::to_string(line_) + ": " + what);
}

}  // namespace plumbline::gap
