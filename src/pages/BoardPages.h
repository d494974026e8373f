#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "pages/PageSource.h"

namespace plumbline::pages {

/// Pages that show texts by name from a board. A page gets each text when it opens and when it has changed; a
/// slow page skips texts and delays nobody. Messages from pages are ignored. Safe between threads.
class BoardPages final : public PageSource {
public:
  /// Replaces the text of that name.
  void put(const std::string& name, std::string text);

  std::unique_ptr<PageSession> open() override;
  std::size_t maxMessage() const override { return 1024; }
  void onNews(std::function<void()> notify) override;

private:
  class Session;
  struct Text {
    std::shared_ptr<const std::string> text;
    std::uint64_t version = 0;
  };

  std::mutex mutex_;
  std::map<std::string, Text> texts_;
  std::uint64_t version_ = 0;
  std::function<void()> notify_;
};

}  // namespace plumbline::pages
