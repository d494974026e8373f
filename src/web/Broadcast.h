#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

namespace plumbline::web {

/// Messages to pages. Each message has the whole state of its channel, so only the last one counts.
enum class Channel : std::uint8_t { geometry, game, drawings, frame, replay };
constexpr std::size_t numChannels = 5;

/// Carries messages from the feed to the pages. It keeps only the last message of each channel: a slow page
/// skips messages and delays nobody. Safe between threads.
class Broadcast {
public:
  using Message = std::shared_ptr<const std::string>;
  struct Latest {
    Message message;  ///< null: none yet
    std::uint64_t version = 0;
  };

  void publish(Channel channel, std::string message);
  Latest latest(Channel channel) const;
  /// Forgets a channel's message.
  void clear(Channel channel);
  /// Called after every publish, in the publisher's thread. Set it before anything is published.
  void onPublish(std::function<void()> notify) { notify_ = std::move(notify); }

private:
  mutable std::mutex mutex_;
  std::array<Latest, numChannels> messages_;
  std::function<void()> notify_;
};

}  // namespace plumbline::web
