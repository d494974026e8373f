#include "framework/ConnectedSocket.h"

#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

namespace plumbline {
namespace {

using Clock = std::chrono::steady_clock;

struct Limits {
  Clock::time_point end;
  int stopDescriptor;
};

/// Waits until the descriptor is ready; 0, ETIMEDOUT, ECANCELED, or poll's errno.
int waitUntilReady(int fd, short events, const Limits& limits) {
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(limits.end - Clock::now()).count();
    std::array<pollfd, 2> waiting{{{fd, events, 0}, {limits.stopDescriptor, POLLIN, 0}}};
    const int ready = poll(waiting.data(), waiting.size(),
                           left < 0 ? 0 : static_cast<int>(std::min<long long>(left, 1 << 30)));
    if (ready < 0 && errno == EINTR) continue;
    if (ready < 0) return errno;
    if (waiting[1].revents != 0) return ECANCELED;
    return ready == 0 ? ETIMEDOUT : 0;
  }
}

/// What looking a name up has brought; shared with the thread that looks, which may outlive the wait.
struct LookUp {
  std::string host, port;
  std::array<int, 2> done{-1, -1};  ///< a pipe that ends when the answer is there
  int code = 0;
  addrinfo* found = nullptr;

  LookUp(std::string host, int port) : host(std::move(host)), port(std::to_string(port)) {}
  LookUp(const LookUp&) = delete;
  LookUp& operator=(const LookUp&) = delete;
  ~LookUp() {
    if (found) freeaddrinfo(found);
    if (done[0] >= 0) close(done[0]);
    endPipe();
  }
  void endPipe() {
    if (done[1] >= 0) close(done[1]);
    done[1] = -1;
  }
  void look(int flags) {
    addrinfo hints{};
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = flags;
    code = getaddrinfo(host.c_str(), port.c_str(), &hints, &found);
  }
};

/// A thread that gets no signal, so that each one wakes who waits. Throws std::system_error without one.
void lookInThread(const std::shared_ptr<LookUp>& names) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const std::unique_ptr<sigset_t, void (*)(sigset_t*)> restored(
      &before, [](sigset_t* mask) { pthread_sigmask(SIG_SETMASK, mask, nullptr); });
  std::thread([names] {
    names->look(0);
    names->endPipe();
  }).detach();
}

/// Looks a host up; empty on success, else why not. A name server may take longer than anybody waits, and no
/// signal stops the system's call: a thread makes it, which is left alone then.
std::string lookUp(const std::shared_ptr<LookUp>& names, const Limits& limits) {
  names->look(AI_NUMERICHOST);
  if (names->code == 0) return {};
  if (pipe2(names->done.data(), O_CLOEXEC) != 0) return std::strerror(errno);
  try {
    lookInThread(names);
  } catch (const std::system_error& error) {
    return error.code().message();
  }
  const int problem = waitUntilReady(names->done[0], POLLIN, limits);
  if (problem == ETIMEDOUT) return "no answer about its name";
  if (problem != 0) return std::strerror(problem);
  return names->code == 0 ? std::string() : gai_strerror(names->code);
}

/// 0 or errno.
int connectTo(int fd, const addrinfo& address, const Limits& limits) {
  if (connect(fd, address.ai_addr, address.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS && errno != EINTR) return errno;
  if (const int problem = waitUntilReady(fd, POLLOUT, limits); problem != 0) return problem;
  int result = 0;
  socklen_t size = sizeof result;
  return getsockopt(fd, SOL_SOCKET, SO_ERROR, &result, &size) == 0 ? result : errno;
}

}  // namespace

ConnectedSocket connectSocket(const std::string& host, int port, double seconds, int stopDescriptor) {
  const Limits limits{
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)),
      stopDescriptor};
  const auto names = std::make_shared<LookUp>(host, port);
  if (const std::string why = lookUp(names, limits); !why.empty()) return {-1, why};
  int problem = ECONNREFUSED;
  for (const addrinfo* one = names->found; one && problem != ECANCELED; one = one->ai_next) {
    const int fd = socket(one->ai_family, one->ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK, one->ai_protocol);
    problem = fd < 0 ? errno : connectTo(fd, *one, limits);
    if (problem == 0) return {fd};
    if (fd >= 0) close(fd);
  }
  return {-1, std::strerror(problem)};
}

}  // namespace plumbline
