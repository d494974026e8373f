#pragma once
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "framework/Streamable.h"

namespace plumbline::record {

/// Writes values in CDR, little endian, as ROS 2 messages are on the wire: four bytes that say so, then each
/// number at a multiple of its size. Lists carry their length, arrays and objects nothing. Messages follow
/// each other in a buffer that is kept and grows.
class CdrOutStream final : public OutStream {
public:
  static constexpr std::size_t headerSize = 4;

  void clear() { size_ = 0; }
  /// A new message; the ones before stay.
  void begin();
  /// Bytes of the message begun last.
  std::size_t messageSize() const { return size_ - start_; }
  std::string_view bytes() const { return {buffer_.data(), size_}; }
  /// Bytes that are no part of a message.
  void append(const void* data, std::size_t size);
  /// Overwrites bytes that are there.
  void put(std::size_t at, const void* data, std::size_t size) {
    std::memcpy(buffer_.data() + at, data, size);
  }
  std::size_t size() const { return size_; }
  void reserve(std::size_t size) { buffer_.resize(size); }

  void writeSigned(std::int64_t value, unsigned bytes) override {
    writeUnsigned(static_cast<std::uint64_t>(value), bytes);
  }
  void writeUnsigned(std::uint64_t value, unsigned bytes) override;
  void writeBool(bool value) override { number(static_cast<std::uint8_t>(value ? 1 : 0)); }
  void writeChar(char value) override { number(value); }
  void writeFloat(float value) override { number(value); }
  void writeDouble(double value) override { number(value); }
  void writeString(std::string_view value) override;
  void writeRaw(const void* data, std::size_t size) override { append(data, size); }
  void writeBlock(NumberType type, const void* data, std::size_t count) override;
  void beginObject() override {}
  void endObject() override {}
  void label(std::string_view) override {}
  void beginList(std::size_t size, bool sized) override {
    if (sized) number(static_cast<std::uint32_t>(size));
  }
  void endList() override {}
  bool flat() const override { return true; }

private:
  static constexpr std::size_t growth = std::size_t{1} << 14;

  void room(std::size_t size) {
    if (buffer_.size() - size_ < size) buffer_.resize(2 * buffer_.size() + size + growth);
  }
  /// Fills up to a multiple of `bytes`, for which there is room.
  void align(std::size_t bytes) {
    const std::size_t over = (size_ - start_ - headerSize) & (bytes - 1);
    if (over == 0) return;
    std::memset(buffer_.data() + size_, 0, bytes - over);
    size_ += bytes - over;
  }
  template <typename T>
  void number(T value) {
    room(2 * sizeof(T));
    align(sizeof(T));
    std::memcpy(buffer_.data() + size_, &value, sizeof(T));
    size_ += sizeof(T);
  }

  std::vector<char> buffer_;
  std::size_t size_ = 0, start_ = 0;
};

/// Reads one message that CdrOutStream, or any other writer of little-endian CDR, wrote. `data` must outlive
/// the stream.
class CdrInStream final : public InStream {
public:
  explicit CdrInStream(std::string_view data);

  void readSigned(std::int64_t& value, unsigned bytes) override;
  void readUnsigned(std::uint64_t& value, unsigned bytes) override;
  void readBool(bool& value) override;
  void readChar(char& value) override { number(value); }
  void readFloat(float& value) override { number(value); }
  void readDouble(double& value) override { number(value); }
  void readString(std::string& value) override;
  void readRaw(void* data, std::size_t size) override;
  void readBlock(NumberType type, void* data, std::size_t count) override;
  void beginObject() override;
  void endObject() override { depth_--; }
  void label(std::string_view) override {}
  void beginList() override;
  bool nextElement() override;
  void endList() override;
  std::optional<std::size_t> blockAhead(NumberType type) override;
  bool flat() const override { return true; }

  std::size_t position() const override { return position_; }
  /// True if every byte was read.
  bool atEnd() const { return position_ == data_.size(); }

private:
  std::size_t aligned(std::size_t at, std::size_t alignment) const {
    const std::size_t over = (at - CdrOutStream::headerSize) & (alignment - 1);
    return over == 0 ? at : at + alignment - over;
  }
  const char* take(std::size_t size, std::size_t alignment);
  /// The next `count` numbers, or null and the error that the first that is missing gives.
  const char* takeNumbers(std::size_t count, unsigned bytes);
  template <typename T>
  void number(T& value) {
    if (const char* data = take(sizeof(T), sizeof(T))) std::memcpy(&value, data, sizeof(T));
  }
  std::size_t readLength(std::size_t limit);

  std::string_view data_;
  std::size_t position_ = 0;
  std::vector<std::size_t> remaining_;  ///< per open list
  unsigned depth_ = 0;
};

/// Reads all of a message into a value. Returns "", or one line of error; then the value may be half read.
template <typename T>
std::string readMessage(std::string_view message, T& value) {
  CdrInStream in(message);
  StreamType<T>::read(in, value);
  if (in.ok() && !in.atEnd()) in.fail("bytes left over");
  return in.error();
}

}  // namespace plumbline::record
