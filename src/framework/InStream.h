#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "framework/NumberBlock.h"

namespace plumbline {

/// Where a Streamable reads itself from. The first error sticks: from then on nothing is read, every target
/// keeps its value, and error() says what was wrong and where.
class InStream {
public:
  /// More elements than this in one list, or bytes in one string, are an error before memory is taken.
  static constexpr std::size_t maxListLength = std::size_t{1} << 20;
  static constexpr std::size_t maxStringLength = std::size_t{1} << 24;
  /// Objects and lists within each other.
  static constexpr unsigned maxDepth = 64;

  virtual ~InStream() = default;
  virtual void readSigned(std::int64_t& value, unsigned bytes) = 0;
  virtual void readUnsigned(std::uint64_t& value, unsigned bytes) = 0;
  virtual void readBool(bool& value) = 0;
  virtual void readChar(char& value) = 0;
  virtual void readFloat(float& value) = 0;
  virtual void readDouble(double& value) = 0;
  virtual void readString(std::string& value) = 0;
  virtual void readRaw(void* data, std::size_t size) = 0;
  /// `count` numbers, to be stored one after the other at `data`, as OutStream::writeBlock wrote them.
  virtual void readBlock(NumberType type, void* data, std::size_t count);

  virtual void beginObject() = 0;
  virtual void endObject() = 0;
  virtual void label(std::string_view name) = 0;
  /// Before the elements of a list of unknown length; then each element after a true from nextElement.
  virtual void beginList() = 0;
  virtual bool nextElement() = 0;
  virtual void endList() = 0;
  /// Behind beginList: how many numbers of the list are there for one readBlock, instead of nextElement.
  /// None: they come one by one, or fewer are there than the list says, which is an error.
  virtual std::optional<std::size_t> blockAhead(NumberType) { return std::nullopt; }
  /// As OutStream::flat.
  virtual bool flat() const { return false; }

  bool ok() const { return error_.empty(); }
  /// Empty, or one line: what was wrong and at which byte.
  const std::string& error() const { return error_; }
  /// Ends reading with this message unless an earlier error has done so.
  void fail(const std::string& message);

protected:
  virtual std::size_t position() const = 0;

private:
  std::string error_;
};

}  // namespace plumbline
