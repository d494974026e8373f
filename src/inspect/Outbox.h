#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "framework/Drawing.h"

namespace plumbline::inspect {

/// The answer to a request.
struct Outcome {
  enum class Kind { value, done, error };
  std::uint64_t request = 0;
  Kind kind = Kind::value;
  std::string text;
  std::shared_ptr<const Drawing> drawing{};
  std::size_t size() const;  ///< bytes that it holds, about
};

/// Queue from the threads of an agent to the thread that answers; no thread waits. Bounded; an entry that
/// does not fit is refused.
class Outbox {
public:
  static constexpr std::size_t most = 8192;
  static constexpr std::size_t mostBytes = std::size_t{16} << 20;

  Outbox() = default;
  ~Outbox() { take(); }
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;

  /// From any thread. False: full, or no memory.
  bool push(Outcome outcome) noexcept;
  /// All in their order; one thread only.
  std::vector<Outcome> take();

private:
  struct Node {
    Outcome outcome;
    Node* next;
  };
  std::atomic<Node*> newest_{nullptr};
  std::atomic<std::size_t> count_{0}, bytes_{0};
};

}  // namespace plumbline::inspect
