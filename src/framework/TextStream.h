#pragma once
#include <string>
#include <string_view>

#include "framework/Streamable.h"

namespace plumbline {

/// The labelled text form: `{[a] 0 [b] 3 [v] 5.820000 [vec] {[x] 2.000000 [y] -1.500000 }}`. Numbers have six
/// decimals unless that would change the value: then as many digits as it takes to read the same value back.
/// Strings are in double, characters in single quotes, with backslash escapes.
class TextOutStream final : public OutStream {
public:
  /// Appends to `target`.
  explicit TextOutStream(std::string& target) : target_(target) {}

  void writeSigned(std::int64_t value, unsigned bytes) override;
  void writeUnsigned(std::uint64_t value, unsigned bytes) override;
  void writeBool(bool value) override;
  void writeChar(char value) override;
  void writeFloat(float value) override;
  void writeDouble(double value) override;
  void writeString(std::string_view value) override;
  /// As hexadecimal digits.
  void writeRaw(const void* data, std::size_t size) override;
  void beginObject() override;
  void endObject() override;
  void label(std::string_view name) override;
  void beginList(std::size_t size, bool sized) override;
  void endList() override { endObject(); }

private:
  void value(std::string_view text);
  void quoted(std::string_view text, char quote);
  void separate();

  std::string& target_;
};

/// Reads the text form. Labels are skipped whatever they say; braces and order matter, spaces do not.
class TextInStream final : public InStream {
public:
  /// `text` must outlive the stream.
  explicit TextInStream(std::string_view text) : text_(text) {}

  void readSigned(std::int64_t& value, unsigned bytes) override;
  void readUnsigned(std::uint64_t& value, unsigned bytes) override;
  void readBool(bool& value) override;
  void readChar(char& value) override;
  void readFloat(float& value) override;
  void readDouble(double& value) override;
  void readString(std::string& value) override;
  void readRaw(void* data, std::size_t size) override;
  void beginObject() override;
  void endObject() override;
  void label(std::string_view) override {}
  void beginList() override;
  bool nextElement() override;
  void endList() override;

  std::size_t position() const override { return position_; }
  /// True if nothing but spaces is left.
  bool atEnd();

private:
  /// Skips spaces and labels.
  void skip();
  /// The next word: up to a space, brace or bracket. Empty with an error if there is none.
  std::string_view word(std::string_view expected);
  void unexpected(std::string_view expected);
  bool readQuoted(std::string& value, char quote);

  std::string_view text_;
  std::size_t position_ = 0;
  std::vector<std::size_t> lengths_;  // elements read, per open list
  unsigned depth_ = 0;
};

/// The value in text form.
template <typename T>
std::string toText(const T& value) {
  std::string result;
  TextOutStream out(result);
  StreamType<T>::write(out, value);
  while (!result.empty() && result.back() == ' ') result.pop_back();
  return result;
}

/// Reads a value from all of `text`. Returns an empty string, or one line of error; then `value` is as
/// before.
template <typename T>
std::string fromText(std::string_view text, T& value) {
  T result = value;
  TextInStream in(text);
  StreamType<T>::read(in, result);
  if (in.ok() && !in.atEnd()) in.fail("text left over");
  if (in.ok()) value = std::move(result);
  return in.error();
}

}  // namespace plumbline
