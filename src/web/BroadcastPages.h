#pragma once
#include <atomic>

#include "pages/PageSource.h"
#include "web/Broadcast.h"
#include "web/Feed.h"

namespace plumbline::web {

/// Pages that all show the messages of a Broadcast; their requests go to the feed.
class BroadcastPages final : public pages::PageSource {
public:
  explicit BroadcastPages(Broadcast& broadcast) : broadcast_(broadcast) {}
  void setFeed(Feed& feed) { feed_ = &feed; }

  std::unique_ptr<pages::PageSession> open() override;
  std::size_t maxMessage() const override { return 4096; }
  void onNews(std::function<void()> notify) override { broadcast_.onPublish(std::move(notify)); }

private:
  class Session;
  Broadcast& broadcast_;
  std::atomic<Feed*> feed_ = nullptr;
};

}  // namespace plumbline::web
