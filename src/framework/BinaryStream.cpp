#include "framework/BinaryStream.h"

#include <bit>
#include <cstring>

namespace plumbline {

void InStream::fail(const std::string& message) {
  if (error_.empty()) error_ = "byte " + std::to_string(position()) + ": " + message;
}

const char* BinaryInStream::take(std::size_t size) {
  if (!ok()) return nullptr;
  if (size > data_.size() - position_) {
    fail(std::to_string(size) + " bytes needed, " + std::to_string(data_.size() - position_) + " left");
    return nullptr;
  }
  const char* result = data_.data() + position_;
  position_ += size;
  return result;
}

const char* BinaryInStream::takeNumbers(std::size_t count, unsigned bytes) {
  const std::size_t there = (data_.size() - position_) / bytes;
  if (ok() && count > there) position_ += there * bytes;
  return take(count > there ? bytes : count * bytes);
}

void BinaryInStream::readUnsigned(std::uint64_t& value, unsigned bytes) {
  const char* data = take(bytes);
  if (!data) return;
  value = 0;
  for (unsigned i = 0; i < bytes; ++i) {
    value |= std::uint64_t{static_cast<unsigned char>(data[i])} << (8 * i);
  }
}

void BinaryInStream::readSigned(std::int64_t& value, unsigned bytes) {
  std::uint64_t bits = 0;
  readUnsigned(bits, bytes);
  if (!ok()) return;
  const unsigned shift = 64 - 8 * bytes;
  value = static_cast<std::int64_t>(bits << shift) >> shift;
}

void BinaryInStream::readBool(bool& value) {
  const char* data = take(1);
  if (!data) return;
  if (*data != 0 && *data != 1) return fail("a bool is 0 or 1");
  value = *data != 0;
}

void BinaryInStream::readChar(char& value) {
  if (const char* data = take(1)) value = *data;
}

void BinaryInStream::readFloat(float& value) {
  std::uint64_t bits = 0;
  readUnsigned(bits, 4);
  if (ok()) value = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
}

void BinaryInStream::readDouble(double& value) {
  std::uint64_t bits = 0;
  readUnsigned(bits, 8);
  if (ok()) value = std::bit_cast<double>(bits);
}

std::size_t BinaryInStream::readLength(std::size_t limit) {
  std::uint64_t length = 0;
  readUnsigned(length, 4);
  if (length > limit) fail("length " + std::to_string(length) + " above " + std::to_string(limit));
  return ok() ? length : 0;
}

void BinaryInStream::readString(std::string& value) {
  const std::size_t length = readLength(maxStringLength);
  if (const char* data = take(length)) value.assign(data, length);
}

void BinaryInStream::readRaw(void* data, std::size_t size) {
  if (const char* source = take(size)) std::memcpy(data, source, size);
}

void BinaryInStream::readBlock(NumberType type, void* data, std::size_t count) {
  if constexpr (std::endian::native == std::endian::little) {
    if (const char* source = takeNumbers(count, type.bytes); source && count > 0)
      std::memcpy(data, source, count * type.bytes);
  } else {
    InStream::readBlock(type, data, count);
  }
}

void BinaryInStream::beginObject() {
  if (++depth_ > maxDepth) fail("nested too deeply");
}

void BinaryInStream::endObject() { depth_--; }

void BinaryInStream::beginList() {
  beginObject();
  remaining_.push_back(readLength(maxListLength));
}

bool BinaryInStream::nextElement() {
  if (!ok() || remaining_.back() == 0) return false;
  remaining_.back()--;
  return true;
}

std::optional<std::size_t> BinaryInStream::blockAhead(NumberType type) {
  if (!ok()) return std::nullopt;
  const std::size_t count = remaining_.back(), before = position_;
  if (!takeNumbers(count, type.bytes)) return std::nullopt;
  position_ = before;
  remaining_.back() = 0;
  return count;
}

void BinaryInStream::endList() {
  remaining_.pop_back();
  endObject();
}

}  // namespace plumbline
