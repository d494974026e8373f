#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "framework/RepresentationLoader.h"

namespace plumbline::record {

/// The parts of a streamed type: enough to split its messages without the type.
struct Schema {
  enum class Kind : std::uint8_t {
    boolean,
    character,
    int8,
    int16,
    int32,
    int64,
    uint8,
    uint16,
    uint32,
    uint64,
    float32,
    float64,
    text,
    raw,     ///< a block of `size` bytes
    object,  ///< its parts one after the other
    list     ///< any number of its one part
  };
  Kind kind = Kind::object;
  std::string label{};
  std::size_t size = 0;
  std::vector<Schema> parts{};

  bool operator==(const Schema&) const = default;
  /// An object whose parts have no labels and are all alike: an array, or a row of a matrix.
  bool isArray() const;
};

/// Found by having a value of the type read itself from a stream in which every list has one element. Throws
/// std::runtime_error for a type without an end (one that holds itself).
Schema schemaOf(const RepresentationLoader& loader);

/// In one line: `{position:{x:f8 y:f8} valid:b angles:{f8*24} names:[s]}`; and back. fromText throws
/// std::runtime_error with what is wrong.
std::string schemaText(const Schema& schema);
Schema schemaFromText(std::string_view text);

}  // namespace plumbline::record
