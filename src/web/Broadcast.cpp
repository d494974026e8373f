#include "web/Broadcast.h"

#include <utility>

namespace plumbline::web {

void Broadcast::publish(Channel channel, std::string message) {
  auto shared = std::make_shared<const std::string>(std::move(message));
  {
    const std::lock_guard lock(mutex);
    Latest& latest = messages[static_cast<std::size_t>(channel)];
    latest.message = std::move(shared);
    ++latest.version;
  }
  if (notify) notify();
}

Broadcast::Latest Broadcast::latest(Channel channel) const {
  const std::lock_guard lock(mutex);
  return messages[static_cast<std::size_t>(channel)];
}

void Broadcast::clear(Channel channel) {
  const std::lock_guard lock(mutex);
  messages[static_cast<std::size_t>(channel)].message = nullptr;
}

}  // namespace plumbline::web
