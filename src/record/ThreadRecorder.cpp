#include "record/ThreadRecorder.h"

#include <chrono>
#include <thread>

namespace plumbline::record {

namespace {
constexpr std::chrono::microseconds pause{200};
}

ThreadRecorder::ThreadRecorder(RecordedThread thread, std::vector<Representation*> values,
                               std::size_t bufferBytes, bool waits)
    : thread_(std::move(thread)),
      values_(std::move(values)),
      ring_(bufferBytes),
      waits_(waits),
      sizes_(values_.size()) {}

void ThreadRecorder::record(std::int64_t timestamp) {
  // A cycle that is missing leaves a gap in the numbers.
  const Header header{++number_, timestamp};
  out_.clear();
  out_.append(&header, sizeof(header));
  const std::size_t sizes = out_.size();
  out_.append(sizes_.data(), sizes_.size() * sizeof(std::uint32_t));
  for (std::size_t i = 0; i < values_.size(); ++i) {
    out_.begin();
    values_[i]->stream(nullptr, &out_);
    if (out_.messageSize() == CdrOutStream::headerSize) out_.writeBool(false);  // without members
    sizes_[i] = static_cast<std::uint32_t>(out_.messageSize());
  }
  out_.put(sizes, sizes_.data(), sizes_.size() * sizeof(std::uint32_t));
  while (closed_.load(std::memory_order_relaxed) || !ring_.push(out_.bytes())) {
    if (!waits_ || closed_.load(std::memory_order_relaxed)) {
      dropped_.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    std::this_thread::sleep_for(pause);
  }
}

bool ThreadRecorder::take(CycleView& cycle) {
  if (!ring_.pop(taken_)) return false;
  Header header{};
  std::memcpy(&header, taken_.data(), sizeof(header));
  cycle.number = header.number;
  cycle.timestamp = header.timestamp;
  cycle.messages.clear();
  std::size_t at = sizeof(header) + values_.size() * sizeof(std::uint32_t);
  for (std::size_t i = 0; i < values_.size(); ++i) {
    std::uint32_t size = 0;
    std::memcpy(&size, taken_.data() + sizeof(header) + i * sizeof(size), sizeof(size));
    cycle.messages.push_back(std::string_view(taken_).substr(at, size));
    at += size;
  }
  return true;
}

}  // namespace plumbline::record
