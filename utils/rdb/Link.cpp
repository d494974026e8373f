#include "Link.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "framework/ConnectedSocket.h"

namespace plumbline::rdb {

namespace {
constexpr std::size_t maxLine = std::size_t{8} << 20;
constexpr double sendSeconds = 5;
}  // namespace

Link::Link(std::string host, int port, std::string token, int stop)
    : host_(std::move(host)), port_(port), token_(std::move(token)), stop_(stop) {}

void Link::close() {
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
  in_.clear();
}

bool Link::wait(short events, double seconds) const {
  pollfd descriptors[] = {{stop_, POLLIN, 0}, {fd_, events, 0}};
  const int ready = poll(descriptors, 2, static_cast<int>(1000 * seconds));
  return ready > 0 && descriptors[0].revents == 0 && descriptors[1].revents != 0;
}

std::string Link::connect(double seconds) {
  close();
  const ConnectedSocket connected = connectSocket(host_, port_, seconds, stop_);
  fd_ = connected.descriptor;
  if (fd_ < 0) return "cannot connect to " + name() + ": " + connected.problem;
  if (!token_.empty()) send(token_);
  return {};
}

bool Link::send(const std::string& line) {
  const std::string text = line + '\n';
  for (std::size_t sent = 0; connected() && sent < text.size();) {
    const ssize_t done = ::send(fd_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (done > 0) sent += static_cast<std::size_t>(done);
    if (done < 0 && errno != EAGAIN && errno != EINTR) close();
    if (done < 0 && connected() && !wait(POLLOUT, sendSeconds)) close();
  }
  return connected();
}

std::vector<std::string> Link::receive(double seconds) {
  std::vector<std::string> lines;
  if (!connected() || !wait(POLLIN, seconds)) return lines;
  char buffer[65536];
  const ssize_t got = recv(fd_, buffer, sizeof(buffer), 0);
  if (got > 0) in_.append(buffer, static_cast<std::size_t>(got));
  const bool lost = got == 0 || (got < 0 && errno != EAGAIN && errno != EINTR);
  std::size_t begin = 0;
  for (std::size_t end; (end = in_.find('\n', begin)) != std::string::npos; begin = end + 1)
    lines.push_back(in_.substr(begin, end - begin));
  in_.erase(0, begin);
  if (lost || in_.size() > maxLine) close();
  return lines;
}

}  // namespace plumbline::rdb
