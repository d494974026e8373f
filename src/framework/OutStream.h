#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "framework/NumberBlock.h"

namespace plumbline {

/// What there is to know of floating-point numbers that pass by.
struct NumberCheck {
  bool any = false, finite = true;
  void see(double value) {
    any = true;
    finite &= std::isfinite(value);
  }
};

/// Where a Streamable writes itself. A stream knows only these few shapes; StreamTypes.h breaks every
/// supported type down to them, and STREAM names the members.
class OutStream {
public:
  virtual ~OutStream() = default;
  /// A value of 1, 2, 4 or 8 bytes.
  virtual void writeSigned(std::int64_t value, unsigned bytes) = 0;
  virtual void writeUnsigned(std::uint64_t value, unsigned bytes) = 0;
  virtual void writeBool(bool value) = 0;
  virtual void writeChar(char value) = 0;
  virtual void writeFloat(float value) = 0;
  virtual void writeDouble(double value) = 0;
  virtual void writeString(std::string_view value) = 0;
  /// A block of memory as it is.
  virtual void writeRaw(const void* data, std::size_t size) = 0;
  /// `count` numbers, stored one after the other at `data`: the same as each by itself, in one piece
  /// where a stream can do that.
  virtual void writeBlock(NumberType type, const void* data, std::size_t count);

  /// Members follow, each with its label, until endObject.
  virtual void beginObject() = 0;
  virtual void endObject() = 0;
  virtual void label(std::string_view name) = 0;
  /// `size` elements follow, until endList. The reader does not know `size` unless `sized`.
  virtual void beginList(std::size_t size, bool sized) = 0;
  virtual void endList() = 0;
  /// True if labels, objects and lists that are not `sized` leave no trace: then numbers in
  /// several of them may come as one block.
  virtual bool flat() const { return false; }
  /// Not null: this stream looks at floating-point numbers alone and writes nothing. Every representation
  /// passes one in every cycle, so its numbers come here without a virtual call for each.
  NumberCheck* check() const { return check_; }

protected:
  OutStream() = default;
  explicit OutStream(NumberCheck& check) : check_(&check) {}

private:
  NumberCheck* check_ = nullptr;
};

}  // namespace plumbline
