#include "record/CdrStream.h"

#include <bit>

namespace plumbline::record {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

namespace {
constexpr char littleEndian[CdrOutStream::headerSize] = {0, 1, 0, 0};
}

void CdrOutStream::begin() {
  start_ = size_;
  append(littleEndian, headerSize);
}

void CdrOutStream::append(const void* data, std::size_t size) {
  room(size);
  if (size > 0) std::memcpy(buffer_.data() + size_, data, size);
  size_ += size;
}

void CdrOutStream::writeUnsigned(std::uint64_t value, unsigned bytes) {
  switch (bytes) {
    case 1:
      return number(static_cast<std::uint8_t>(value));
    case 2:
      return number(static_cast<std::uint16_t>(value));
    case 4:
      return number(static_cast<std::uint32_t>(value));
    default:
      return number(value);
  }
}

void CdrOutStream::writeBlock(NumberType type, const void* data, std::size_t count) {
  if (count == 0) return;
  room((count + 1) * type.bytes);
  align(type.bytes);
  std::memcpy(buffer_.data() + size_, data, count * type.bytes);
  size_ += count * type.bytes;
}

void CdrOutStream::writeString(std::string_view value) {
  // The length counts the zero at the end.
  number(static_cast<std::uint32_t>(value.size() + 1));
  append(value.data(), value.size());
  append("", 1);
}

CdrInStream::CdrInStream(std::string_view data) : data_(data) {
  const char* header = take(CdrOutStream::headerSize, 1);
  if (header && std::memcmp(header, littleEndian, sizeof(littleEndian)) != 0) fail("is no little-endian CDR");
}

const char* CdrInStream::take(std::size_t size, std::size_t alignment) {
  if (!ok()) return nullptr;
  const std::size_t at = aligned(position_, alignment);
  if (at > data_.size() || size > data_.size() - at) {
    fail(std::to_string(size) + " bytes needed, " +
         std::to_string(at > data_.size() ? 0 : data_.size() - at) + " left");
    return nullptr;
  }
  position_ = at + size;
  return data_.data() + at;
}

const char* CdrInStream::takeNumbers(std::size_t count, unsigned bytes) {
  if (!ok()) return nullptr;
  const std::size_t start = aligned(position_, bytes);
  const std::size_t there = start > data_.size() ? 0 : (data_.size() - start) / bytes;
  if (count > there && there > 0) position_ = start + there * bytes;
  return count > there ? take(bytes, bytes) : take(count * bytes, bytes);
}

void CdrInStream::readUnsigned(std::uint64_t& value, unsigned bytes) {
  const char* data = take(bytes, bytes);
  if (!data) return;
  value = 0;
  std::memcpy(&value, data, bytes);
}

void CdrInStream::readSigned(std::int64_t& value, unsigned bytes) {
  std::uint64_t bits = 0;
  readUnsigned(bits, bytes);
  if (!ok()) return;
  const unsigned shift = 64 - 8 * bytes;
  value = static_cast<std::int64_t>(bits << shift) >> shift;
}

void CdrInStream::readBool(bool& value) {
  const char* data = take(1, 1);
  if (!data) return;
  if (*data != 0 && *data != 1) return fail("a bool is 0 or 1");
  value = *data != 0;
}

std::size_t CdrInStream::readLength(std::size_t limit) {
  std::uint64_t length = 0;
  readUnsigned(length, 4);
  if (ok() && length > limit) fail("length " + std::to_string(length) + " above " + std::to_string(limit));
  return ok() ? length : 0;
}

void CdrInStream::readString(std::string& value) {
  const std::size_t length = readLength(maxStringLength + 1);
  if (!ok()) return;
  if (length == 0) return fail("a text has a zero at its end");
  const char* data = take(length, 1);
  if (!data) return;
  if (data[length - 1] != 0) return fail("a text has a zero at its end");
  value.assign(data, length - 1);
}

void CdrInStream::readRaw(void* data, std::size_t size) {
  if (const char* source = take(size, 1)) std::memcpy(data, source, size);
}

void CdrInStream::readBlock(NumberType type, void* data, std::size_t count) {
  if (count == 0) return;
  if (const char* source = takeNumbers(count, type.bytes)) std::memcpy(data, source, count * type.bytes);
}

void CdrInStream::beginObject() {
  if (++depth_ > maxDepth) fail("nested too deeply");
}

void CdrInStream::beginList() {
  beginObject();
  remaining_.push_back(readLength(maxListLength));
}

bool CdrInStream::nextElement() {
  if (!ok() || remaining_.back() == 0) return false;
  remaining_.back()--;
  return true;
}

std::optional<std::size_t> CdrInStream::blockAhead(NumberType type) {
  if (!ok()) return std::nullopt;
  const std::size_t count = remaining_.back(), before = position_;
  if (count > 0 && !takeNumbers(count, type.bytes)) return std::nullopt;
  position_ = before;
  remaining_.back() = 0;
  return count;
}

void CdrInStream::endList() {
  remaining_.pop_back();
  endObject();
}

}  // namespace plumbline::record
