#pragma once
#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::record {

/// Blocks of bytes from one thread to one other, of bounded size; neither ever waits for the other.
class CycleRing {
public:
  /// The size is rounded up to a power of two; all of it is touched now, so that no cycle does it first.
  explicit CycleRing(std::size_t bytes) : buffer_(std::bit_ceil(bytes)), mask_(buffer_.size() - 1) {
    std::memset(buffer_.data(), 0, buffer_.size());
  }

  /// False: there is no room now.
  bool push(std::string_view block) {
    const auto size = static_cast<std::uint32_t>(block.size());
    const std::size_t head = head_.load(std::memory_order_relaxed);
    const std::size_t used = head - tail_.load(std::memory_order_acquire);
    if (sizeof(size) + block.size() > buffer_.size() - used) return false;
    put(head, &size, sizeof(size));
    put(head + sizeof(size), block.data(), block.size());
    head_.store(head + sizeof(size) + block.size(), std::memory_order_release);
    return true;
  }

  /// False: nothing is there.
  bool pop(std::string& block) {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    if (head_.load(std::memory_order_acquire) == tail) return false;
    std::uint32_t size = 0;
    get(tail, &size, sizeof(size));
    block.resize(size);
    get(tail + sizeof(size), block.data(), size);
    tail_.store(tail + sizeof(size) + size, std::memory_order_release);
    return true;
  }

private:
  void put(std::size_t at, const void* data, std::size_t size) {
    const std::size_t first = std::min(size, buffer_.size() - (at & mask_));
    std::memcpy(buffer_.data() + (at & mask_), data, first);
    std::memcpy(buffer_.data(), static_cast<const char*>(data) + first, size - first);
  }
  void get(std::size_t at, void* data, std::size_t size) const {
    const std::size_t first = std::min(size, buffer_.size() - (at & mask_));
    std::memcpy(data, buffer_.data() + (at & mask_), first);
    std::memcpy(static_cast<char*>(data) + first, buffer_.data(), size - first);
  }

  std::vector<char> buffer_;
  std::size_t mask_;
  alignas(64) std::atomic<std::size_t> head_{0};
  alignas(64) std::atomic<std::size_t> tail_{0};
};

}  // namespace plumbline::record
