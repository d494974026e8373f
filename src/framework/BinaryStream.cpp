#include "framework/BinaryStream.h"

#include <bit>
#include <cstring>

namespace plumbline {

void InStream::fail(const std::string& message) {
  if (error_.empty()) error_ = "byte " + std::to_string(position()) + ": " + message;
}

void BinaryOutStream::writeUnsigned(std::uint64_t value, unsigned bytes) {
  char buffer[8];
  for (unsigned i = 0; i < bytes; i++) buffer[i] = static_cast<char>(value >> (8 * i));
  target_.append(buffer, bytes);
}

void BinaryOutStream::writeSigned(std::int64_t value, unsigned bytes) {
  writeUnsigned(static_cast<std::uint64_t>(value), bytes);
}

void BinaryOutStream::writeBool(bool value) { target_.push_back(value ? 1 : 0); }
void BinaryOutStream::writeChar(char value) { target_.push_back(value); }
void BinaryOutStream::writeFloat(float value) { writeUnsigned(std::bit_cast<std::uint32_t>(value), 4); }
void BinaryOutStream::writeDouble(double value) { writeUnsigned(std::bit_cast<std::uint64_t>(value), 8); }

void BinaryOutStream::writeString(std::string_view value) {
  writeUnsigned(value.size(), 4);
  target_.append(value);
}

void BinaryOutStream::writeRaw(const void* data, std::size_t size) {
  target_.append(static_cast<const char*>(data), size);
}

void BinaryOutStream::beginList(std::size_t size, bool sized) {
  if (sized) writeUnsigned(size, 4);
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

void BinaryInStream::readUnsigned(std::uint64_t& value, unsigned bytes) {
  const char* data = take(bytes);
  if (!data) return;
  value = 0;
  for (unsigned i = 0; i < bytes; i++) {
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

void BinaryInStream::endList() {
  remaining_.pop_back();
  endObject();
}

}  // namespace plumbline
