#include "simspark/ChildProcess.h"

#include <fcntl.h>
#include <linux/close_range.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

#include "simspark/Patience.h"

namespace plumbline::simspark {
namespace {

constexpr int groupLooks = 50;  ///< for the end of a killed child's group, 5 ms apart

/// Pointers to the texts, which stay where they are, with the null that ends them.
std::vector<char*> pointersTo(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

/// Waits for a number from the other end; false if that closes without one. A signal meanwhile says nothing.
bool receiveNumber(int socket, int& number) {
  ssize_t count = 0;
  do {
    count = read(socket, &number, sizeof number);
  } while (count < 0 && errno == EINTR);
  return count == sizeof number;
}

/// What the other end does not wait for any more is lost.
void sendNumber(int socket, int number) { ::send(socket, &number, sizeof number, MSG_NOSIGNAL); }

std::vector<std::string> environmentOf(const ChildSettings& settings) {
  std::vector<std::string> all = settings.environment;
  for (char** one = environ; *one != nullptr; ++one) {
    const std::string text = *one;
    const std::string name = text.substr(0, text.find('=') + 1);
    const auto isBegin = [&](const std::string& begin) { return text.starts_with(begin); };
    const auto isReplaced = [&](const std::string& other) { return other.starts_with(name); };
    if (std::ranges::none_of(settings.dropped, isBegin) &&
        std::ranges::none_of(settings.environment, isReplaced))
      all.push_back(text);
  }
  return all;
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& argv, const ChildSettings& settings)
    : wholeGroup_(settings.wholeGroup) {
  // The parent's and the child's end, which exec closes. A child whose group is guarded waits until the guard
  // is there, so that nothing it starts is left behind; if exec fails, it sends its errno.
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::runtime_error(std::string("socketpair: ") + std::strerror(errno));
  const std::vector<char*> arguments = pointersTo(argv);
  const std::vector<std::string> variables = environmentOf(settings);
  const std::vector<char*> environment = pointersTo(variables);
  const pid_t parent = getpid();

  pid_ = fork();
  if (pid_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(126);  // the parent died before prctl
    setpgid(0, 0);                        // Ctrl-C goes to the parent, which then stops its children in order
    close(ends[0]);
    int guarded = 0;
    if (settings.wholeGroup && !receiveNumber(ends[1], guarded)) _exit(126);  // the parent died before that
    signal(SIGPIPE, SIG_DFL);
    if (!settings.outputFile.empty()) {
      const int file = open(settings.outputFile.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
      if (file >= 0) {
        dup2(file, STDOUT_FILENO);
        dup2(file, STDERR_FILENO);
      }
    }
    close_range(STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC);  // what libraries have open is not the child's
    if (settings.onPath)
      execvpe(arguments[0], arguments.data(), environment.data());
    else
      execve(arguments[0], arguments.data(), environment.data());
    sendNumber(ends[1], errno);
    _exit(127);
  }
  int error = pid_ < 0 ? errno : 0;
  close(ends[1]);
  if (pid_ > 0 && wholeGroup_) {
    try {
      guard_ = std::make_unique<GroupGuard>(pid_);
    } catch (const std::runtime_error&) {
      close(ends[0]);
      kill(pid_, SIGKILL);
      reap(0);
      throw;
    }
    sendNumber(ends[0], 1);
  }
  const bool failed = pid_ < 0 || receiveNumber(ends[0], error);
  close(ends[0]);
  if (!failed) return;
  if (pid_ > 0) reap(0);
  throw std::runtime_error("cannot start " + argv[0] + ": " + std::strerror(error));
}

ChildProcess::~ChildProcess() { stop(); }

bool ChildProcess::reap(int options) {
  if (exitStatus_) return true;
  if (wholeGroup_) {
    // Until it is reaped its number, and so the group's, is nobody else's.
    siginfo_t ended{};
    while (waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOWAIT | options) < 0 &&
           errno == EINTR) {
    }
    if (ended.si_pid == 0) return false;
    kill(-pid_, SIGKILL);
    guard_.reset();
  }
  int status = 0;
  rusage used{};
  pid_t result = 0;
  do {
    result = wait4(pid_, &status, options, &used);
  } while (result < 0 && errno == EINTR);
  if (result == 0) return false;
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  usage_ = {seconds(used.ru_utime) + seconds(used.ru_stime), static_cast<double>(used.ru_maxrss) / 1024.0};
  exitStatus_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return true;
}

bool ChildProcess::running() { return !reap(WNOHANG); }

void ChildProcess::signalGroup(int signal) {
  if (running()) kill(-pid_, signal);
}

void ChildProcess::sendSignal(int signal) { kill(wholeGroup_ ? -pid_ : pid_, signal); }

void ChildProcess::askToStop(double patienceSeconds) {
  if (patience_ || !running()) return;
  sendSignal(SIGTERM);
  patience_.emplace(pid_, patienceSeconds);
}

void ChildProcess::stop(double patienceSeconds) {
  askToStop(patienceSeconds);
  while (running() && !patience_->isOver()) usleep(5000);
  if (!running()) return;
  sendSignal(SIGKILL);
  reap(0);
  // Who writes down where it hung is in its group. It must still see this process, or it takes the child for
  // one that was taken along (CrashLog), and writes nothing. A whole group was killed with it.
  for (int i = 0; !wholeGroup_ && i < groupLooks && kill(-pid_, 0) == 0; ++i) usleep(5000);
}

}  // namespace plumbline::simspark
