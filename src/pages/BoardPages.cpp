#include "pages/BoardPages.h"

#include <utility>

namespace plumbline::pages {

class BoardPages::Session final : public PageSession {
public:
  explicit Session(BoardPages& board) : board_(board) {}

  bool receive(std::string_view) override { return true; }

  Kind next(std::string& message) override {
    const std::lock_guard lock(board_.mutex_);
    // The oldest news first, so that a text that changes all the time lets the others through.
    const Text* oldest = nullptr;
    const std::string* name = nullptr;
    for (const auto& [key, text] : board_.texts_) {
      if (text.version <= sent_[key] || (oldest && oldest->version < text.version)) continue;
      oldest = &text;
      name = &key;
    }
    if (!oldest) return Kind::nothing;
    sent_[*name] = oldest->version;
    message += *oldest->text;
    return Kind::text;
  }

private:
  BoardPages& board_;
  std::map<std::string, std::uint64_t> sent_;
};

void BoardPages::put(const std::string& name, std::string text) {
  const std::lock_guard lock(mutex_);
  texts_[name] = {std::make_shared<const std::string>(std::move(text)), ++version_};
  if (notify_) notify_();
}

std::unique_ptr<PageSession> BoardPages::open() { return std::make_unique<Session>(*this); }

void BoardPages::onNews(std::function<void()> notify) {
  const std::lock_guard lock(mutex_);
  notify_ = std::move(notify);
}

}  // namespace plumbline::pages
