#pragma once
#include <chrono>

namespace plumbline::rdb {

/// A clock that only goes on, from an unknown begin [s].
inline double clockSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace plumbline::rdb
