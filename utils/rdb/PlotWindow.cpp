#include "PlotWindow.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <utility>

#include "Plot.h"
#include "framework/SteadyClock.h"

namespace plumbline::rdb {
namespace {

constexpr int noGnuplot = 127, noTerminal = 3;  ///< how the child ends

/// Ends a gnuplot that was built without windows.
constexpr const char* openWindow = "if (GPVAL_TERM eq \"unknown\") exit status 3\n";

bool isSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value && *value;
}

}  // namespace

bool PlotWindow::possible() { return isSet("DISPLAY") || isSet("WAYLAND_DISPLAY"); }

PlotWindow::PlotWindow(const std::string& title) : title_(title) {
  int ends[2];
  // A socket, for a pipe would end this process when gnuplot goes.
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    problem_ = "no connection to gnuplot";
    return;
  }
  child_ = fork();
  if (child_ == 0) {
    setpgid(0, 0);  // Ctrl-C is the console's
    const int null = open("/dev/null", O_WRONLY);
    dup2(ends[0], STDIN_FILENO);
    dup2(null, STDOUT_FILENO);
    dup2(null, STDERR_FILENO);
    execlp("gnuplot", "gnuplot", static_cast<char*>(nullptr));
    _exit(noGnuplot);
  }
  close(ends[0]);
  socket_ = ends[1];
  if (child_ < 0) end("gnuplot cannot be started");
  unsent_ = openWindow;
}

PlotWindow::~PlotWindow() { end(""); }

void PlotWindow::end(const std::string& why) {
  problem_ = why;
  if (socket_ >= 0) close(std::exchange(socket_, -1));
  if (child_ <= 0) return;
  kill(child_, SIGTERM);
  for (int i = 0; i < 100 && waitpid(child_, nullptr, WNOHANG) == 0; ++i) usleep(1000);
  kill(child_, SIGKILL);
  waitpid(std::exchange(child_, -1), nullptr, 0);
}

void PlotWindow::show(const Plot& plot) {
  if (child_ <= 0) return;
  int status = 0;
  if (waitpid(child_, &status, WNOHANG) == child_) {
    child_ = -1;
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    return end(code == noGnuplot    ? "gnuplot draws the windows and is not there: install gnuplot-qt"
               : code == noTerminal ? "gnuplot can open no window here: install gnuplot-qt"
                                    : "the window is closed");
  }
  if (unsent_.empty() && steadySeconds() >= next_) {
    next_ = steadySeconds() + plot.interval();
    unsent_ = plot.script(title_);
  }
  send();
}

void PlotWindow::send() {
  while (!unsent_.empty()) {
    const ssize_t written = ::send(socket_, unsent_.data(), unsent_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;  // full, or gnuplot is gone, which show() notices
    unsent_.erase(0, static_cast<std::size_t>(written));
  }
}

std::string PlotWindow::problem() { return std::exchange(problem_, ""); }

}  // namespace plumbline::rdb
