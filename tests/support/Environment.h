#pragma once
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace plumbline::bench {

/// A whole number of the environment, or another where it is not set. Throws std::runtime_error for what is
/// none.
inline std::uint64_t environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  if (!text || !*text) return otherwise;
  char* end = nullptr;
  const std::uint64_t value = std::strtoull(text, &end, 10);
  if (*end || *text == '-')
    throw std::runtime_error(std::string(name) + "=" + text + " is no whole number; leave it out for " +
                             std::to_string(otherwise));
  return value;
}

/// A text of the environment, or another where it is not set.
inline std::string environmentText(const char* name, const char* otherwise) {
  const char* text = std::getenv(name);
  return text && *text ? text : otherwise;
}

}  // namespace plumbline::bench
