#pragma once
#include <bit>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "framework/Streamable.h"

namespace plumbline {

/// One value after another, little endian, in the size the member has; no labels, no padding. Strings and
/// lists carry a length of 4 bytes in front. `Sink` takes the bytes: append(const void*, std::size_t).
template <typename Sink>
class BinaryOut final : public OutStream {
public:
  template <typename... Arguments>
  explicit BinaryOut(Arguments&&... arguments) : sink_(std::forward<Arguments>(arguments)...) {}
  const Sink& sink() const { return sink_; }

  void writeSigned(std::int64_t value, unsigned bytes) override {
    writeUnsigned(static_cast<std::uint64_t>(value), bytes);
  }
  void writeUnsigned(std::uint64_t value, unsigned bytes) override {
    char buffer[8];
    for (unsigned i = 0; i < bytes; ++i) buffer[i] = static_cast<char>(value >> (8 * i));
    sink_.append(buffer, bytes);
  }
  void writeBool(bool value) override { writeChar(value ? 1 : 0); }
  void writeChar(char value) override { sink_.append(&value, 1); }
  void writeFloat(float value) override { writeUnsigned(std::bit_cast<std::uint32_t>(value), 4); }
  void writeDouble(double value) override { writeUnsigned(std::bit_cast<std::uint64_t>(value), 8); }
  void writeString(std::string_view value) override {
    writeUnsigned(value.size(), 4);
    sink_.append(value.data(), value.size());
  }
  void writeRaw(const void* data, std::size_t size) override { sink_.append(data, size); }
  void writeBlock(NumberType type, const void* data, std::size_t count) override {
    if constexpr (std::endian::native == std::endian::little)
      sink_.append(data, type.bytes * count);
    else
      OutStream::writeBlock(type, data, count);
  }
  void beginObject() override {}
  void endObject() override {}
  void label(std::string_view) override {}
  void beginList(std::size_t size, bool sized) override {
    if (sized) writeUnsigned(size, 4);
  }
  void endList() override {}
  bool flat() const override { return true; }

private:
  Sink sink_;
};

/// Appends to a string that outlives it.
class StringSink {
public:
  explicit StringSink(std::string& target) : target_(target) {}
  void append(const void* data, std::size_t size) { target_.append(static_cast<const char*>(data), size); }

private:
  std::string& target_;
};

/// Counts the bytes.
class CountingSink {
public:
  void append(const void*, std::size_t size) { size_ += size; }
  std::size_t size() const { return size_; }

private:
  std::size_t size_ = 0;
};

/// Fills memory that outlives it. What does not fit any more is left out, and full() says so.
class MemorySink {
public:
  MemorySink(void* memory, std::size_t size) : at_(static_cast<char*>(memory)), left_(size) {}
  void append(const void* data, std::size_t size) {
    full_ = full_ || size > left_;
    if (full_ || size == 0) return;
    std::memcpy(at_, data, size);
    at_ += size;
    left_ -= size;
  }
  bool full() const { return full_; }
  std::size_t left() const { return left_; }

private:
  char* at_;
  std::size_t left_;
  bool full_ = false;
};

using BinaryOutStream = BinaryOut<StringSink>;

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
  void readBlock(NumberType type, void* data, std::size_t count) override;
  void beginObject() override;
  void endObject() override;
  void label(std::string_view) override {}
  void beginList() override;
  bool nextElement() override;
  void endList() override;
  std::optional<std::size_t> blockAhead(NumberType type) override;
  bool flat() const override { return true; }

  /// Bytes read so far.
  std::size_t position() const override { return position_; }
  /// True if every byte was read.
  bool atEnd() const { return position_ == data_.size(); }

private:
  /// The next `size` bytes, or null and an error.
  const char* take(std::size_t size);
  /// The next `count` numbers, or null and the error that the first that is missing gives.
  const char* takeNumbers(std::size_t count, unsigned bytes);
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
