#pragma once
#include <atomic>
#include <mutex>

#include "motion/Keyframes.h"

namespace plumbline {

/// What a person who edits motions wants to see played, between the modules of an agent; nothing in a game.
/// Safe between threads.
class EditedMotion {
public:
  static constexpr const char* name = "(draft)";  ///< asks for the draft as the name of a file asks for it

  void setDraft(motion::KeyframeMotion motion) {
    const std::lock_guard lock(mutex_);
    draft_ = std::move(motion);
  }
  motion::KeyframeMotion draft() const {
    const std::lock_guard lock(mutex_);
    return draft_;
  }
  /// A file was written: who has read motions reads them again.
  void save() { saved_.fetch_add(1); }
  unsigned saved() const { return saved_.load(std::memory_order_relaxed); }

private:
  mutable std::mutex mutex_;
  motion::KeyframeMotion draft_;
  std::atomic<unsigned> saved_{0};
};

}  // namespace plumbline
