#include "tunnel/CarriedConnection.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>

namespace plumbline::tunnel {
namespace {

constexpr int framesAtOnce = 8;  // then others have their turn

bool wouldBlock(int error) { return error == EAGAIN || error == EWOULDBLOCK; }

}  // namespace

bool isItsOwnPeer(int fd) {
  sockaddr_in own{}, peer{};
  socklen_t ownSize = sizeof own, peerSize = sizeof peer;
  return getsockname(fd, reinterpret_cast<sockaddr*>(&own), &ownSize) == 0 &&
         getpeername(fd, reinterpret_cast<sockaddr*>(&peer), &peerSize) == 0 &&
         own.sin_port == peer.sin_port && own.sin_addr.s_addr == peer.sin_addr.s_addr;
}

void CarriedConnection::use(int fd, bool connecting) {
  fd_ = fd;
  connecting_ = connecting;
  const int on = 1;
  setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  if (!connecting) flush();
}

short CarriedConnection::events() const {
  if (fd_ < 0) return 0;
  if (connecting_) return POLLOUT;
  const bool reads = !localEnd_ && !peerReset_ && allowed_ > 0;
  return static_cast<short>((reads ? POLLIN : 0) | (waiting_.empty() ? 0 : POLLOUT));
}

void CarriedConnection::serve(short revents) {
  if (fd_ < 0 || revents == 0) return;
  if (connecting_) {
    int error = 0;
    socklen_t size = sizeof error;
    getsockopt(fd_, SOL_SOCKET, SO_ERROR, &error, &size);
    if (error != 0 || isItsOwnPeer(fd_)) return close();
    connecting_ = false;
  }
  if (revents & POLLOUT) flush();
  if (revents & (POLLIN | POLLHUP | POLLERR)) receive();
}

void CarriedConnection::receive() {
  char buffer[maxFrameData];
  for (int i = 0; i < framesAtOnce && !quiet() && !peerReset_ && allowed_ > 0; ++i) {
    const ssize_t count = recv(fd_, buffer, std::min<std::size_t>(sizeof buffer, allowed_), MSG_DONTWAIT);
    if (count > 0) {
      allowed_ -= static_cast<std::uint32_t>(count);
      send_({FrameKind::data, id_, 0, std::string(buffer, static_cast<std::size_t>(count))});
    } else if (count == 0) {
      localEnd_ = true;
      send_({FrameKind::end, id_});
      checkOver();
    } else if (errno != EINTR) {
      if (!wouldBlock(errno)) reset();
      return;
    }
  }
}

void CarriedConnection::flush() {
  while (fd_ >= 0 && !connecting_ && !waiting_.empty()) {
    const ssize_t count = ::send(fd_, waiting_.data(), waiting_.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && wouldBlock(errno)) break;
    if (count < 0) return reset();
    waiting_.erase(0, static_cast<std::size_t>(count));
    passedOn_ += static_cast<std::uint32_t>(count);
  }
  // Not for every few bytes: the other end has three quarters of the window left at least.
  if (passedOn_ >= creditWindow / 4 && !peerEnd_ && !peerReset_) {
    send_({FrameKind::credit, id_, passedOn_});
    passedOn_ = 0;
  }
  checkOver();
}

void CarriedConnection::take(const Frame& frame) {
  if (over_) return;  // what was on its way when it ended here
  switch (frame.kind) {
    case FrameKind::data:
      if (peerEnd_ || peerReset_)
        throw std::invalid_argument("data after the end of connection " + std::to_string(id_));
      if (waiting_.size() + passedOn_ + frame.data.size() > creditWindow)
        throw std::invalid_argument("more than the " + std::to_string(creditWindow) +
                                    " bytes that connection " + std::to_string(id_) + " may be sent");
      waiting_ += frame.data;
      break;
    case FrameKind::end:
      peerEnd_ = true;
      break;
    case FrameKind::reset:
      peerReset_ = true;
      break;
    case FrameKind::credit:
      if (frame.value > creditWindow - allowed_)
        throw std::invalid_argument("credit for more than connection " + std::to_string(id_) + " has sent");
      allowed_ += frame.value;
      return;
    default:
      throw std::invalid_argument("a frame that is none of connection " + std::to_string(id_));
  }
  flush();
}

void CarriedConnection::reset() {
  if (over_) return;
  if (!peerReset_) send_({FrameKind::reset, id_});
  closeReset();
}

void CarriedConnection::closeReset() {
  // The program at this end learns that it broke, as it would without a tunnel.
  const linger now{1, 0};
  if (fd_ >= 0) setsockopt(fd_, SOL_SOCKET, SO_LINGER, &now, sizeof now);
  close();
  over_ = true;
}

void CarriedConnection::checkOver() {
  if (over_ || !waiting_.empty()) return;
  if (peerReset_) return closeReset();
  if (fd_ < 0 || connecting_ || !peerEnd_) return;
  if (!shut_) ::shutdown(fd_, SHUT_WR);
  shut_ = true;
  if (!localEnd_) return;
  close();
  over_ = true;
}

void CarriedConnection::close() {
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
  connecting_ = false;
}

}  // namespace plumbline::tunnel
