#include "framework/PartialFolder.h"

#include <mutex>
#include <new>
#include <system_error>
#include <utility>

namespace plumbline {
namespace {

std::mutex mutex;
PartialFolder* first = nullptr;  // of those that there are; a list through them, which needs no memory

}  // namespace

PartialFolder::PartialFolder(std::filesystem::path path) : path_(std::move(path)) {
  const std::lock_guard lock(mutex);
  next_ = std::exchange(first, this);
}

PartialFolder::~PartialFolder() {
  remove();
  const std::lock_guard lock(mutex);
  PartialFolder** link = &first;
  while (*link != this) link = &(*link)->next_;
  *link = next_;
}

void PartialFolder::remove() const {
  if (kept_) return;
  try {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  } catch (const std::bad_alloc&) {
    // It stays, as after a kill; the next run removes it.
  }
}

void PartialFolder::removeAll() noexcept {
  const std::unique_lock lock(mutex, std::try_to_lock);
  if (!lock) return;
  for (const PartialFolder* folder = first; folder != nullptr; folder = folder->next_) folder->remove();
}

}  // namespace plumbline
