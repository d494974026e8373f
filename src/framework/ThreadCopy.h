#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "framework/RepresentationLoader.h"

namespace plumbline {

/// Carries representations from one thread to another. The source thread publishes all of them at the end of
/// its cycle, the destination fetches them at the beginning of its own: always all of one cycle, the newest.
/// Three sets of copies change hands by one atomic exchange, so neither side ever waits or sees a
/// half-written value (a triple buffer).
class ThreadCopy {
public:
  /// Both must live as long as this; before the first publish.
  void add(const RepresentationLoader& loader, const Representation& source, Representation& target);

  /// Called by the source thread.
  void publish();
  /// Called by the destination thread. False, and nothing changes, if nothing new was published.
  bool fetch();

private:
  struct Entry {
    const RepresentationLoader* loader;
    const Representation* source;
    Representation* target;
    std::array<std::unique_ptr<RepresentationHolder>, 3> owners;
    std::array<Representation*, 3> copies;
  };
  static constexpr std::uint8_t indexMask = 3, fresh = 4;

  std::vector<Entry> entries_;
  // Apart from each other, so that the threads do not share cache lines they only use themselves.
  alignas(64) std::uint8_t writing_ = 0;
  alignas(64) std::atomic<std::uint8_t> middle_{1};
  alignas(64) std::uint8_t reading_ = 2;
};

}  // namespace plumbline
