#include "simspark/GroupGuard.h"

#include <fcntl.h>
#include <sys/prctl.h>
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
[[noreturn]] void guard(int pipeEnd, pid_t group) {
  setsid();  // whoever signals the parent's group does not mean the guard
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  prctl(PR_SET_NAME, "group-guard");  // as ps shows it
  dup2(pipeEnd, STDIN_FILENO);
  close_range(STDIN_FILENO + 1, ~0U, 0);  // it keeps nobody's files and sockets open
  char released = 0;
  ssize_t count = 0;
  do {
    count = read(STDIN_FILENO, &released, 1);
  } while (count < 0 && errno == EINTR);
  if (count == 0) kill(-group, SIGKILL);  // the end of the pipe: the parent has gone
  _exit(0);
}

}  // namespace

GroupGuard::GroupGuard(pid_t group) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw std::runtime_error(std::string("cannot guard processes: ") + std::strerror(errno));
  pid_ = fork();
  if (pid_ == 0) {
    close(ends[1]);
    guard(ends[0], group);
  }
  const int error = errno;
  close(ends[0]);
  pipe_ = ends[1];
  if (pid_ > 0) return;
  close(pipe_);
  throw std::runtime_error(std::string("cannot guard processes: ") + std::strerror(error));
}

GroupGuard::~GroupGuard() {
  const char released = 1;
  [[maybe_unused]] const auto written = write(pipe_, &released, 1);
  close(pipe_);
  while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace plumbline::simspark
