#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace plumbline::pages {

/// One page's conversation. The server's thread calls it.
class PageSession {
public:
  enum class Kind { nothing, text, binary, end };

  virtual ~PageSession() = default;
  /// A whole message of the page. False: the conversation is over.
  virtual bool receive(std::string_view message) = 0;
  /// Appends the next message for the page, if there is one now; called when the page has taken the last.
  virtual Kind next(std::string& message) = 0;
};

/// What a server's pages talk to. Must outlive the server.
class PageSource {
public:
  virtual ~PageSource() = default;
  /// Null: it has no place for one more.
  virtual std::unique_ptr<PageSession> open() = 0;
  /// The longest message of a page [bytes].
  virtual std::size_t maxMessage() const = 0;
  /// Called, from any thread, whenever there may be a message for some page.
  virtual void onNews(std::function<void()> notify) = 0;
};

}  // namespace plumbline::pages
