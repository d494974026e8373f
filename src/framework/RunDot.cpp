#include "framework/RunDot.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>

#include "framework/StopSignal.h"
#include "parameters/Range.h"

namespace plumbline {
namespace {

using Clock = std::chrono::steady_clock;

/// The program as the leader of a group of its own, so that what it starts ends with it. It dies with this
/// process.
class DotProcess {
public:
  explicit DotProcess(char* const* arguments) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) {
      error_ = errno;
      return;
    }
    const pid_t parent = getpid();
    pid_ = fork();
    if (pid_ == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (getppid() != parent) _exit(126);  // it died before prctl
      setpgid(0, 0);
      execvp(arguments[0], arguments);
      const int reason = errno;
      [[maybe_unused]] const auto sent = ::write(ends[1], &reason, sizeof reason);
      _exit(127);
    }
    if (pid_ < 0) error_ = errno;
    close(ends[1]);
    ssize_t count = 0;
    do {
      count = ::read(ends[0], &error_, sizeof error_);  // closed by exec
    } while (count < 0 && errno == EINTR);
    close(ends[0]);
  }
  ~DotProcess() {
    if (pid_ <= 0 || status_) return;
    kill(-pid_, SIGKILL);
    wait(0);
  }
  DotProcess(const DotProcess&) = delete;
  DotProcess& operator=(const DotProcess&) = delete;

  /// Why it was not started; 0: it was.
  int error() const { return error_; }
  bool hasEnded() {
    wait(WNOHANG);
    return status_.has_value();
  }
  /// Of one that has ended: whether it has done its work.
  bool succeeded() const { return WIFEXITED(*status_) && WEXITSTATUS(*status_) == 0; }

private:
  void wait(int options) {
    int status = 0;
    pid_t result = 0;
    do {
      result = waitpid(pid_, &status, options);
    } while (result < 0 && errno == EINTR);
    if (result != 0) status_ = status;
  }

  pid_t pid_ = -1;
  int error_ = 0;
  std::optional<int> status_;
};

/// Waits so long for a request to stop [s].
bool isReadable(int descriptor, double seconds) {
  pollfd entry{descriptor, POLLIN, 0};
  return poll(&entry, 1, static_cast<int>(1e3 * seconds)) > 0 && descriptor >= 0;
}

}  // namespace

std::string runDot(const std::string& format, const std::string& input, const std::string& output,
                   double seconds) {
  std::string type = "-T" + format, program = "dot", option = "-o";
  std::string in = input, out = output;
  char* arguments[] = {program.data(), type.data(), in.data(), option.data(), out.data(), nullptr};
  // An agent that was stopped draws its graph after that: only a later signal would end the drawing, and a
  // second one ends the agent anyway.
  int stop = StopSignal::caughtDescriptor();
  if (isReadable(stop, 0)) stop = -1;
  DotProcess dot(arguments);
  if (dot.error() == ENOENT)
    return "Graphviz's program dot is not installed; install graphviz or write a .dot file";
  if (dot.error() != 0) return std::string("dot cannot be started: ") + std::strerror(dot.error());
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (!dot.hasEnded()) {
    if (Clock::now() > end)
      return "dot has not drawn it within " + shortestText(seconds) +
             " s; write a .dot file and see what `dot -T" + format + " FILE.dot` does";
    if (isReadable(stop, 0.01)) throw Stopped();
  }
  return dot.succeeded() ? "" : "dot failed";
}

}  // namespace plumbline
