#include "simspark/GroupGuard.h"

#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <string>

namespace plumbline::simspark {
namespace {

/// Never returns. Only what is allowed between fork and exec: the parent may have threads.
[[noreturn]] void guard(int end, pid_t group) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  prctl(PR_SET_NAME, "group-guard");  // as ps shows it
  dup2(end, STDIN_FILENO);
  close_range(STDIN_FILENO + 1, ~0U, 0);  // it keeps nobody's files and sockets open
  char released = 0;
  ssize_t count = 0;
  do {
    count = read(STDIN_FILENO, &released, 1);
  } while (count < 0 && errno == EINTR);
  if (count == 0) kill(-group, SIGKILL);  // nothing was said, and the parent has gone
  _exit(0);
}

}  // namespace

GroupGuard::GroupGuard(pid_t group) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::runtime_error(std::string("cannot guard processes: ") + std::strerror(errno));
  pid_ = fork();
  const int error = errno;
  // Whoever signals the parent's group does not mean the guard. It leaves the group by both its own hand and
  // the parent's: whichever is first, it has left when this returns.
  setpgid(pid_, pid_);
  if (pid_ == 0) {
    close(ends[1]);
    guard(ends[0], group);
  }
  close(ends[0]);
  end_ = ends[1];
  if (pid_ > 0) return;
  close(end_);
  throw std::runtime_error(std::string("cannot guard processes: ") + std::strerror(error));
}

GroupGuard::~GroupGuard() {
  const char released = 1;
  send(end_, &released, 1, MSG_NOSIGNAL);  // it may have been killed itself
  close(end_);
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace plumbline::simspark
