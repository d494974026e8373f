#include "framework/PartialFolder.h"

#include <new>
#include <system_error>

namespace plumbline {

PartialFolder::~PartialFolder() {
  if (kept_) return;
  try {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  } catch (const std::bad_alloc&) {
    // It stays, as after a kill; the next run takes it away.
  }
}

}  // namespace plumbline
