#include "framework/NumberBlock.h"

#include <cstring>

#include "framework/InStream.h"
#include "framework/OutStream.h"

namespace plumbline {
namespace {

/// Calls `function` with a value of the type.
template <typename F>
void withNumber(NumberType type, F&& function) {
  using Kind = NumberType::Kind;
  const bool isSigned = type.kind == Kind::signedInteger;
  if (type.kind == Kind::character) return function(char{});
  if (type.kind == Kind::floatingPoint) return type.bytes == 4 ? function(float{}) : function(double{});
  switch (type.bytes) {
    case 1:
      return isSigned ? function(std::int8_t{}) : function(std::uint8_t{});
    case 2:
      return isSigned ? function(std::int16_t{}) : function(std::uint16_t{});
    case 4:
      return isSigned ? function(std::int32_t{}) : function(std::uint32_t{});
    default:
      return isSigned ? function(std::int64_t{}) : function(std::uint64_t{});
  }
}

void write(OutStream& out, char value) { out.writeChar(value); }
void write(OutStream& out, float value) { out.writeFloat(value); }
void write(OutStream& out, double value) { out.writeDouble(value); }
template <std::signed_integral T>
void write(OutStream& out, T value) {
  out.writeSigned(value, sizeof(T));
}
template <std::unsigned_integral T>
void write(OutStream& out, T value) {
  out.writeUnsigned(value, sizeof(T));
}

void read(InStream& in, char& value) { in.readChar(value); }
void read(InStream& in, float& value) { in.readFloat(value); }
void read(InStream& in, double& value) { in.readDouble(value); }
template <std::signed_integral T>
void read(InStream& in, T& value) {
  std::int64_t wide = value;
  in.readSigned(wide, sizeof(T));
  value = static_cast<T>(wide);
}
template <std::unsigned_integral T>
void read(InStream& in, T& value) {
  std::uint64_t wide = value;
  in.readUnsigned(wide, sizeof(T));
  value = static_cast<T>(wide);
}

}  // namespace

void OutStream::writeBlock(NumberType type, const void* data, std::size_t count) {
  withNumber(type, [&](auto value) {
    const char* at = static_cast<const char*>(data);
    for (std::size_t i = 0; i < count; ++i, at += sizeof value) {
      std::memcpy(&value, at, sizeof value);
      write(*this, value);
    }
  });
}

void InStream::readBlock(NumberType type, void* data, std::size_t count) {
  withNumber(type, [&](auto value) {
    char* at = static_cast<char*>(data);
    for (std::size_t i = 0; i < count && ok(); ++i, at += sizeof value) {
      std::memcpy(&value, at, sizeof value);
      read(*this, value);
      std::memcpy(at, &value, sizeof value);
    }
  });
}

}  // namespace plumbline
