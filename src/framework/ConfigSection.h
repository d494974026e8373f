#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parameters/Range.h"

namespace plumbline {

struct ConfigNode;

// Reading one value: throws ConfigurationError naming file, line and key if it is of another type, not finite
// or out of range.
void readConfig(const ConfigNode& node, const Range& range, bool& value);
void readConfig(const ConfigNode& node, const Range& range, int& value);
void readConfig(const ConfigNode& node, const Range& range, unsigned& value);
void readConfig(const ConfigNode& node, const Range& range, std::int64_t& value);
void readConfig(const ConfigNode& node, const Range& range, float& value);
void readConfig(const ConfigNode& node, const Range& range, double& value);
void readConfig(const ConfigNode& node, const Range& range, std::string& value);

/// The elements of a list, which must be `size` unless that is negative.
std::vector<const ConfigNode*> configElements(const ConfigNode& node, int size = -1);

template <typename T>
void readConfig(const ConfigNode& node, const Range& range, std::vector<T>& value) {
  value.clear();
  for (const ConfigNode* element : configElements(node)) {
    T entry{};
    readConfig(*element, range, entry);
    value.push_back(std::move(entry));
  }
}

template <typename T, std::size_t n>
void readConfig(const ConfigNode& node, const Range& range, std::array<T, n>& value) {
  std::size_t i = 0;
  for (const ConfigNode* element : configElements(node, n)) readConfig(*element, range, value[i++]);
}

/// Eigen's vectors (a list) and matrices (a list of rows) of fixed size.
template <typename M>
requires(M::RowsAtCompileTime > 0 && M::ColsAtCompileTime > 0) void readConfig(const ConfigNode& node,
                                                                               const Range& range, M& value) {
  constexpr int rows = M::RowsAtCompileTime, columns = M::ColsAtCompileTime;
  constexpr bool isVector = rows == 1 || columns == 1;
  int i = 0;
  for (const ConfigNode* element : configElements(node, isVector ? rows * columns : rows)) {
    if constexpr (isVector) {
      readConfig(*element, range, value.coeffRef(i));
    } else {
      int j = 0;
      for (const ConfigNode* entry : configElements(*element, columns)) {
        readConfig(*entry, range, value.coeffRef(i, j++));
      }
    }
    i++;
  }
}

/// A map of config values: a whole file or a part of it. Reading a value declares it: once everybody has read
/// what they need, a key nobody asked for is an error (see ConfigFile). Every error is a ConfigurationError
/// naming file, line and key. Keys of maps within the map are written with dots: "walk.stepHeight".
///
/// Types: bool, int, unsigned, std::int64_t, float, double, std::string; std::vector and std::array of those;
/// Eigen's vectors and matrices of fixed size.
class ConfigSection {
public:
  ConfigSection() = default;
  ConfigSection(std::shared_ptr<const ConfigNode> root, const ConfigNode& map)
      : root_(std::move(root)), map_(&map) {}

  /// The value of a key that must be there. A range holds for every number in the value.
  template <typename T>
  T get(std::string_view key, Range range = {}) const {
    T value{};
    readConfig(required(key), range, value);
    return value;
  }
  template <typename T>
  T get(std::string_view key, double min, double max) const {
    return get<T>(key, Range{min, max});
  }
  /// The value of a key that may be missing.
  template <typename T>
  std::optional<T> find(std::string_view key, Range range = {}) const {
    const ConfigNode* node = optional(key);
    if (!node) return std::nullopt;
    T value{};
    readConfig(*node, range, value);
    return value;
  }
  bool has(std::string_view key) const { return optional(key) != nullptr; }
  /// The node of a key, null if it is missing: for readConfig().
  const ConfigNode* node(std::string_view key) const { return optional(key); }
  /// The index of the key's value among the words it may be.
  std::size_t choice(std::string_view key, const std::vector<std::string>& words) const;

  /// The map below a key that must be there.
  ConfigSection section(std::string_view key) const;
  /// The maps in the list below a key that must be there.
  std::vector<ConfigSection> list(std::string_view key) const;
  /// The keys of this map in the order of the file, for maps whose keys are data. Declares none of them.
  std::vector<std::string> keys() const;
  /// Throws ConfigurationError: `file:line: key message`.
  [[noreturn]] void fail(std::string_view key, const std::string& message) const;

private:
  const ConfigNode& required(std::string_view key) const;
  const ConfigNode* optional(std::string_view key) const;

  std::shared_ptr<const ConfigNode> root_;
  const ConfigNode* map_ = nullptr;
};

}  // namespace plumbline
