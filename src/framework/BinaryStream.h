#pragma once
#include <string>
#include <string_view>

#include "framework/Streamable.h"

namespace plumbline {

/// One value after another, little endian, in the size the member has; no labels, no padding. Strings and
/// lists carry a length of 4 bytes in front.
class BinaryOutStream final : public OutStream {
public:
  /// Appends to `target`.
  explicit BinaryOutStream(std::string& target) : target_(target) {}

  void writeSigned(std::int64_t value, unsigned bytes) override;
  void writeUnsigned(std::uint64_t value, unsigned bytes) override;
  void writeBool(bool value) override;
  void writeChar(char value) override;
  void writeFloat(float value) override;
  void writeDouble(double value) override;
  void writeString(std::string_view value) override;
  void writeRaw(const void* data, std::size_t size) override;
  void beginObject() override {}
  void endObject() override {}
  void label(std::string_view) override {}
  void beginList(std::size_t size, bool sized) override;
  void endList() override {}

private:
  std::string& target_;
};

/// Reads what BinaryOutStream wrote. `data` must outlive the stream.
class BinaryInStream final : public InStream {
public:
  explicit BinaryInStream(std::string_view data) : data_(data) {}

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

  /// Bytes read so far.
  std::size_t position() const override { return position_; }
  /// True if every byte was read.
  bool atEnd() const { return position_ == data_.size(); }

private:
  /// The next `size` bytes, or null and an error.
  const char* take(std::size_t size);
  /// A length in front of a string or list, not above `limit`.
  std::size_t readLength(std::size_t limit);

  std::string_view data_;
  std::size_t position_ = 0;
  std::vector<std::size_t> remaining_;  // per open list
  unsigned depth_ = 0;
};

/// The value as bytes.
template <typename T>
std::string toBinary(const T& value) {
  std::string result;
  BinaryOutStream out(result);
  StreamType<T>::write(out, value);
  return result;
}

/// Reads a value from all of `data`. Returns an empty string, or one line of error; then `value` is as
/// before.
template <typename T>
std::string fromBinary(std::string_view data, T& value) {
  T result = value;
  BinaryInStream in(data);
  StreamType<T>::read(in, result);
  if (in.ok() && !in.atEnd()) in.fail("bytes left over");
  if (in.ok()) value = std::move(result);
  return in.error();
}

}  // namespace plumbline
