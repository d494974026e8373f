#pragma once
#include <cstdint>

namespace plumbline {

/// A number computed from bytes (FNV-1a, 64 bits): the same on every machine, no secret.
class Fingerprint {
public:
  void add(unsigned char byte) { value_ = (value_ ^ byte) * 1099511628211ull; }
  std::uint64_t value() const { return value_; }

private:
  std::uint64_t value_ = 14695981039346656037ull;
};

}  // namespace plumbline
