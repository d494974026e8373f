#pragma once
#include <chrono>
#include <thread>

namespace plumbline {

/// What a test waits for comes long before, also on a busy machine: only what never comes takes so long [s].
/// tests/support/far-off.bash has the same for scripts.
inline constexpr double farOff = 600;

/// Whether a condition comes true, looked at every 5 ms.
template <typename Condition>
bool comesTrue(Condition condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(farOff);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

}  // namespace plumbline
