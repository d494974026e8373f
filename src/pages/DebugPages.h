#pragma once
#include <atomic>
#include <mutex>
#include <thread>

#include "inspect/DebugServer.h"
#include "pages/PageSource.h"

namespace plumbline::pages {

/// Pages that speak the debug protocol (doc/reference/debug-protocol.md): a message is one line or several of
/// it, in both directions. Each page is a client of the server like bin/rdb, with the same limits: a page
/// that does not read misses values and gets their number.
class DebugPages final : public PageSource {
public:
  /// The server must outlive this.
  explicit DebugPages(inspect::DebugServer& server);
  ~DebugPages() override;
  DebugPages(const DebugPages&) = delete;
  DebugPages& operator=(const DebugPages&) = delete;

  std::unique_ptr<PageSession> open() override;
  std::size_t maxMessage() const override { return inspect::DebugServer::maxLine; }
  void onNews(std::function<void()> notify) override;

private:
  void wait();

  inspect::DebugServer& server_;
  int waiting_ = -1, ending_ = -1;  ///< all connections; readable at the end
  std::mutex mutex_;
  std::function<void()> notify_;
  std::thread thread_;
};

}  // namespace plumbline::pages
