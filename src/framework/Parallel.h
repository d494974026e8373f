#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "framework/StopSignal.h"

namespace plumbline {

/// The number of threads asked for; 0: as many as the machine has cores.
inline int threadsFor(int asked) {
  return asked > 0 ? asked : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// Calls work(i) for i = 0 .. count-1 on so many threads; results must go to places of their own, so that
/// their number does not change them. The first exception is thrown on. Throws Stopped once a signal that
/// StopSignal catches has come.
inline void parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr error;
  std::mutex mutex;
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        StopSignal::throwIfCaught();
        work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!error) error = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::jthread> pool;
  for (int i = 1; i < threads && static_cast<std::size_t>(i) < count; ++i) pool.emplace_back(run);
  run();
  pool.clear();
  if (error) std::rethrow_exception(error);
}

}  // namespace plumbline
