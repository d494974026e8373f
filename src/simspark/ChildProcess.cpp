#include "simspark/ChildProcess.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace plumbline::simspark {

ChildProcess::ChildProcess(const std::vector<std::string>& argv, const std::string& outputFile) {
  // A pipe that exec closes: if exec fails, the child sends its errno through it.
  int report[2];
  if (pipe2(report, O_CLOEXEC) != 0) throw std::runtime_error(std::string("pipe: ") + std::strerror(errno));
  std::vector<char*> arguments;
  arguments.reserve(argv.size() + 1);
  for (const std::string& argument : argv) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  const pid_t parent = getpid();

  pid_ = fork();
  if (pid_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(126);  // the parent died before prctl
    setpgid(0, 0);                        // Ctrl-C goes to the parent, which then stops its children in order
    signal(SIGPIPE, SIG_DFL);
    if (!outputFile.empty()) {
      const int file = open(outputFile.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
      if (file >= 0) {
        dup2(file, STDOUT_FILENO);
        dup2(file, STDERR_FILENO);
      }
    }
    execv(arguments[0], arguments.data());
    const int error = errno;
    [[maybe_unused]] const auto written = write(report[1], &error, sizeof error);
    _exit(127);
  }
  close(report[1]);
  int error = 0;
  const bool failed = pid_ < 0 || read(report[0], &error, sizeof error) == sizeof error;
  close(report[0]);
  if (!failed) return;
  if (pid_ > 0) reap(0);
  throw std::runtime_error("cannot start " + argv[0] + ": " + std::strerror(pid_ < 0 ? errno : error));
}

ChildProcess::~ChildProcess() { stop(); }

bool ChildProcess::reap(int options) {
  if (exitStatus_) return true;
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

void ChildProcess::stop(double patienceSeconds) {
  if (!running()) return;
  kill(pid_, SIGTERM);
  const int tries = static_cast<int>(patienceSeconds / 0.005);
  for (int i = 0; i < tries && running(); ++i) usleep(5000);
  if (!running()) return;
  kill(pid_, SIGKILL);
  reap(0);
}

}  // namespace plumbline::simspark
