#include "web/BroadcastPages.h"

namespace plumbline::web {

class BroadcastPages::Session final : public pages::PageSession {
public:
  explicit Session(BroadcastPages& pages) : pages_(pages) {}

  bool receive(std::string_view message) override {
    PageCommand command;
    Feed* feed = pages_.feed_;
    if (parsePageCommand(message, command).empty() && feed) feed->command(command);
    return true;
  }

  Kind next(std::string& message) override {
    for (std::size_t i = 0; i < numChannels; ++i) {
      const std::size_t channel = (nextChannel_ + i) % numChannels;
      const auto [latest, version] = pages_.broadcast_.latest(static_cast<Channel>(channel));
      if (!latest || version == sent_[channel]) continue;
      sent_[channel] = version;
      nextChannel_ = (channel + 1) % numChannels;
      message += *latest;
      return static_cast<Channel>(channel) == Channel::frame ? Kind::binary : Kind::text;
    }
    return Kind::nothing;
  }

private:
  BroadcastPages& pages_;
  std::array<std::uint64_t, numChannels> sent_{};
  std::size_t nextChannel_ = 0;
};

std::unique_ptr<pages::PageSession> BroadcastPages::open() { return std::make_unique<Session>(*this); }

}  // namespace plumbline::web
