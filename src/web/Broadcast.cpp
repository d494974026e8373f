#include "web/Broadcast.h"

#include <utility>

namespace plumbline::web {

void Broadcast::publish(Channel channel, std::string message) {
  auto shared = std::make_shared<const std::string>(std::move(message));
  {
    const std::lock_guard lock(mutex_);
    Latest& latest = messages_[static_cast<std::size_t>(channel)];
    latest.message = std::move(shared);
    ++latest.version;
  }
  if (notify_) notify_();
}

Broadcast::Latest Broadcast::latest(Channel channel) const {
  const std::lock_guard lock(mutex_);
  return messages_[static_cast<std::size_t>(channel)];
}

void Broadcast::clear(Channel channel) {
  const std::lock_guard lock(mutex_);
  messages_[static_cast<std::size_t>(channel)].message = nullptr;
}

}  // namespace plumbline::web
