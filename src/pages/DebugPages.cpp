#include "pages/DebugPages.h"

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <stdexcept>

namespace plumbline::pages {
namespace {

constexpr std::size_t atOnce = std::size_t{64} << 10;  ///< bytes of a message to a page, about

class LineSession final : public PageSession {
public:
  explicit LineSession(int fd) : fd_(fd) {}
  ~LineSession() override { ::close(fd_); }

  bool receive(std::string_view message) override {
    std::string lines(message);
    lines += '\n';
    // The server reads at once; a page that asks faster than that has lost its mind.
    return ::send(fd_, lines.data(), lines.size(), MSG_DONTWAIT | MSG_NOSIGNAL) ==
           static_cast<ssize_t>(lines.size());
  }

  Kind next(std::string& message) override {
    std::array<char, 16384> bytes;
    while (!ended_ && rest_.size() < atOnce) {
      const ssize_t got = recv(fd_, bytes.data(), bytes.size(), MSG_DONTWAIT);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0 && errno == EAGAIN) break;
      if (got <= 0) ended_ = true;
      if (got > 0) rest_.append(bytes.data(), static_cast<std::size_t>(got));
    }
    // Whole lines only: half of a character is no text.
    const auto end = rest_.rfind('\n');
    if (end == std::string::npos) return ended_ ? Kind::end : Kind::nothing;
    message.append(rest_, 0, end);
    rest_.erase(0, end + 1);
    return Kind::text;
  }

private:
  int fd_;
  bool ended_ = false;
  std::string rest_;
};

}  // namespace

DebugPages::DebugPages(inspect::DebugServer& server) : server_(server) {
  waiting_ = epoll_create1(EPOLL_CLOEXEC);
  ending_ = eventfd(0, EFD_CLOEXEC);
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = ending_;
  if (waiting_ < 0 || ending_ < 0 || epoll_ctl(waiting_, EPOLL_CTL_ADD, ending_, &event) != 0)
    throw std::runtime_error("no descriptor is left for the page");
  thread_ = std::thread([this] { wait(); });
}

DebugPages::~DebugPages() {
  const std::uint64_t one = 1;
  if (::write(ending_, &one, sizeof one) == sizeof one) thread_.join();
  ::close(ending_);
  ::close(waiting_);
}

std::unique_ptr<PageSession> DebugPages::open() {
  try {
    const int fd = server_.join();
    auto session = std::make_unique<LineSession>(fd);
    epoll_event event{};
    // At each arrival once: the server's thread reads when the page can take more.
    event.events = EPOLLIN | EPOLLRDHUP | EPOLLET;
    event.data.fd = fd;
    if (epoll_ctl(waiting_, EPOLL_CTL_ADD, fd, &event) != 0) return nullptr;
    return session;
  } catch (const std::runtime_error&) {
    return nullptr;
  }
}

void DebugPages::onNews(std::function<void()> notify) {
  const std::lock_guard lock(mutex_);
  notify_ = std::move(notify);
}

void DebugPages::wait() {
  std::array<epoll_event, 16> events{};
  for (;;) {
    const int count = epoll_wait(waiting_, events.data(), static_cast<int>(events.size()), -1);
    if (count < 0 && errno != EINTR) return;
    for (int i = 0; i < count; ++i)
      if (events[static_cast<std::size_t>(i)].data.fd == ending_) return;
    const std::lock_guard lock(mutex_);
    if (notify_) notify_();
  }
}

}  // namespace plumbline::pages
