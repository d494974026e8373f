#include "dds/StreamShape.h"

#include <string_view>

#include "math/Fingerprint.h"

namespace plumbline::dds {
namespace {

/// Hashes the type and label of each value, not the value itself.
class ShapeStream final : public OutStream {
public:
  void writeSigned(std::int64_t, unsigned bytes) override { add('i', bytes); }
  void writeUnsigned(std::uint64_t, unsigned bytes) override { add('u', bytes); }
  void writeBool(bool) override { add('b', 1); }
  void writeChar(char) override { add('c', 1); }
  void writeFloat(float) override { add('f', 4); }
  void writeDouble(double) override { add('d', 8); }
  void writeString(std::string_view) override { add('s', 0); }
  void writeRaw(const void*, std::size_t size) override { add('r', size); }
  void beginObject() override { add('{', 0); }
  void endObject() override { add('}', 0); }
  void label(std::string_view name) override {
    for (const char c : name) hash.add(static_cast<unsigned char>(c));
  }
  // A list of any length adds neither its length nor, where it is empty, its elements.
  void beginList(std::size_t size, bool sized) override { add('[', sized ? 0 : size); }
  void endList() override { add(']', 0); }

  Fingerprint hash;

private:
  void add(char kind, std::size_t size) {
    hash.add(static_cast<unsigned char>(kind));
    for (; size > 0; size >>= 8) hash.add(static_cast<unsigned char>(size & 255));
  }
};

}  // namespace

std::uint64_t shapeOf(Representation& value) {
  ShapeStream out;
  value.stream(nullptr, &out);
  return out.hash.value();
}

}  // namespace plumbline::dds
