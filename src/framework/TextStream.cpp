#include "framework/TextStream.h"

#include <cfloat>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

namespace plumbline {
namespace {

template <typename T>
bool parse(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

/// Six decimals if they say it all, otherwise the shortest text that reads back the same.
template <typename T>
std::string realText(T value) {
  char buffer[64];
  if (std::abs(value) < 1e15) {
    const auto size = std::snprintf(buffer, sizeof(buffer), "%.6f", static_cast<double>(value));
    T back = 0;
    if (parse(std::string_view(buffer, size), back) && back == value) return std::string(buffer, size);
  }
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof(buffer), value);
  return std::string(buffer, error == std::errc{} ? end : buffer);
}

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

constexpr char hexDigits[] = "0123456789abcdef";

}  // namespace

void TextOutStream::separate() {
  if (!target_.empty() && target_.back() == '}') target_.push_back(' ');
}

void TextOutStream::value(std::string_view text) {
  separate();
  target_.append(text);
  target_.push_back(' ');
}

void TextOutStream::quoted(std::string_view text, char quote) {
  separate();
  target_.push_back(quote);
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == quote || c == '\\') {
      target_.push_back('\\');
      target_.push_back(c);
    } else if (c == '\n') {
      target_.append("\\n");
    } else if (byte < 0x20 || byte == 0x7f) {
      target_.append({'\\', 'x', hexDigits[byte >> 4], hexDigits[byte & 15]});
    } else {
      target_.push_back(c);
    }
  }
  target_.push_back(quote);
  target_.push_back(' ');
}

void TextOutStream::writeSigned(std::int64_t number, unsigned) { value(std::to_string(number)); }
void TextOutStream::writeUnsigned(std::uint64_t number, unsigned) { value(std::to_string(number)); }
void TextOutStream::writeBool(bool flag) { value(flag ? "true" : "false"); }
void TextOutStream::writeChar(char c) { quoted(std::string_view(&c, 1), '\''); }
void TextOutStream::writeFloat(float number) { value(realText(number)); }
void TextOutStream::writeDouble(double number) { value(realText(number)); }
void TextOutStream::writeString(std::string_view text) { quoted(text, '"'); }

void TextOutStream::writeRaw(const void* data, std::size_t size) {
  std::string digits = "#";
  for (std::size_t i = 0; i < size; ++i) {
    const auto byte = static_cast<const unsigned char*>(data)[i];
    digits.push_back(hexDigits[byte >> 4]);
    digits.push_back(hexDigits[byte & 15]);
  }
  value(digits);
}

void TextOutStream::beginObject() {
  separate();
  target_.push_back('{');
}

void TextOutStream::endObject() { target_.push_back('}'); }

void TextOutStream::beginList(std::size_t, bool) { beginObject(); }

void TextOutStream::label(std::string_view name) {
  separate();
  target_.push_back('[');
  target_.append(name);
  target_.append("] ");
}

void TextInStream::skip() {
  bool inLabel = false;
  for (; position_ < text_.size(); ++position_) {
    const char c = text_[position_];
    if (inLabel) {
      inLabel = c != ']';
    } else if (c == '[') {
      inLabel = true;
    } else if (c != ' ' && c != '\n' && c != '\t' && c != '\r') {
      return;
    }
  }
}

void TextInStream::unexpected(std::string_view expected) {
  std::string message = "expected " + std::string(expected) + ", found ";
  if (position_ >= text_.size()) return fail(message + "the end");
  std::string found;
  for (std::size_t i = position_; i < text_.size() && found.size() < 20; ++i) {
    const char c = text_[i];
    if (c == ' ' || c == '\n' || (i > position_ && (c == '{' || c == '}'))) break;
    found.push_back(static_cast<unsigned char>(c) < 0x20 ? '?' : c);
  }
  fail(message + '"' + found + '"');
}

std::string_view TextInStream::word(std::string_view expected) {
  if (!ok()) return {};
  skip();
  std::size_t end = position_;
  while (end < text_.size() &&
         std::string_view(" \n\t\r{}[]\"'").find(text_[end]) == std::string_view::npos) {
    end++;
  }
  if (end == position_) {
    unexpected(expected);
    return {};
  }
  return text_.substr(position_, end - position_);
}

void TextInStream::readSigned(std::int64_t& value, unsigned bytes) {
  const std::string_view text = word("an integer");
  if (!ok()) return;
  std::int64_t number = 0;
  const std::int64_t limit = static_cast<std::int64_t>(~std::uint64_t{0} >> (65 - 8 * bytes));
  if (!parse(text, number) || number > limit || number < -limit - 1) {
    return unexpected("an integer of " + std::to_string(bytes) + " bytes");
  }
  position_ += text.size();
  value = number;
}

void TextInStream::readUnsigned(std::uint64_t& value, unsigned bytes) {
  const std::string_view text = word("an integer");
  if (!ok()) return;
  std::uint64_t number = 0;
  if (!parse(text, number) || number > ~std::uint64_t{0} >> (64 - 8 * bytes)) {
    return unexpected("an unsigned integer of " + std::to_string(bytes) + " bytes");
  }
  position_ += text.size();
  value = number;
}

void TextInStream::readBool(bool& value) {
  const std::string_view text = word("true or false");
  if (!ok()) return;
  if (text != "true" && text != "false" && text != "1" && text != "0") return unexpected("true or false");
  position_ += text.size();
  value = text == "true" || text == "1";
}

void TextInStream::readChar(char& value) {
  std::string text;
  const std::size_t start = position_;
  if (!readQuoted(text, '\'')) return;
  if (text.size() != 1) {
    position_ = start;
    return fail("expected one character in single quotes");
  }
  value = text[0];
}

void TextInStream::readFloat(float& value) {
  const std::string_view text = word("a number");
  if (!ok()) return;
  float number = 0;
  if (!parse(text, number)) return unexpected("a number");
  position_ += text.size();
  value = number;
}

void TextInStream::readDouble(double& value) {
  const std::string_view text = word("a number");
  if (!ok()) return;
  double number = 0;
  if (!parse(text, number)) return unexpected("a number");
  position_ += text.size();
  value = number;
}

bool TextInStream::readQuoted(std::string& value, char quote) {
  if (!ok()) return false;
  skip();
  if (position_ >= text_.size() || text_[position_] != quote) {
    unexpected(quote == '"' ? "a string in double quotes" : "a character in single quotes");
    return false;
  }
  std::string result;
  for (position_++; position_ < text_.size() && text_[position_] != quote; ++position_) {
    char c = text_[position_];
    if (c == '\\' && position_ + 1 < text_.size()) {
      c = text_[++position_];
      if (c == 'n') c = '\n';
      if (c == 'x') {
        const int high = position_ + 2 < text_.size() ? hexDigit(text_[position_ + 1]) : -1;
        const int low = position_ + 2 < text_.size() ? hexDigit(text_[position_ + 2]) : -1;
        if (high < 0 || low < 0) {
          fail("\\x needs two hexadecimal digits");
          return false;
        }
        c = static_cast<char>(16 * high + low);
        position_ += 2;
      }
    }
    if (result.size() == maxStringLength) {
      fail("string too long");
      return false;
    }
    result.push_back(c);
  }
  if (position_ >= text_.size()) {
    fail("missing closing quote");
    return false;
  }
  position_++;
  value = std::move(result);
  return true;
}

void TextInStream::readString(std::string& value) { readQuoted(value, '"'); }

void TextInStream::readRaw(void* data, std::size_t size) {
  const std::string_view text = word("# and hexadecimal digits");
  if (!ok()) return;
  if (text.size() != 2 * size + 1 || text[0] != '#') {
    return unexpected("# and " + std::to_string(2 * size) + " hexadecimal digits");
  }
  for (const char c : text.substr(1)) {
    if (hexDigit(c) < 0) return unexpected("# and hexadecimal digits");
  }
  for (std::size_t i = 0; i < size; ++i) {
    static_cast<unsigned char*>(data)[i] =
        static_cast<unsigned char>(16 * hexDigit(text[2 * i + 1]) + hexDigit(text[2 * i + 2]));
  }
  position_ += text.size();
}

void TextInStream::beginObject() {
  if (!ok()) return;
  skip();
  if (position_ >= text_.size() || text_[position_] != '{') return unexpected("{");
  position_++;
  if (++depth_ > maxDepth) fail("nested too deeply");
}

void TextInStream::endObject() {
  if (!ok()) return;
  skip();
  if (position_ >= text_.size() || text_[position_] != '}') return unexpected("}");
  position_++;
  depth_--;
}

void TextInStream::beginList() {
  beginObject();
  lengths_.push_back(0);
}

bool TextInStream::nextElement() {
  if (!ok()) return false;
  skip();
  if (position_ < text_.size() && text_[position_] == '}') return false;
  if (++lengths_.back() > maxListLength) {
    fail("list longer than " + std::to_string(maxListLength));
    return false;
  }
  return true;
}

void TextInStream::endList() {
  lengths_.pop_back();
  endObject();
}

bool TextInStream::atEnd() {
  skip();
  return position_ == text_.size();
}

}  // namespace plumbline
