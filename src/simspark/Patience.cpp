#include "simspark/Patience.h"

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace plumbline::simspark {
namespace {

// Without C++'s streams and paths: it is asked in destructors, also when there is no memory.

constexpr double longest = 30;  // [s]

using Text = std::array<char, 512>;

struct Activity {
  bool wantsToGoOn = false;  ///< a thread is ready to run or waits for a disk
  double ran = 0;            ///< all threads [s]
};

/// The beginning of a file; empty if there is none.
Text beginOf(int folder, const char* thread, const char* file) {
  Text text{}, path{};
  std::snprintf(path.data(), path.size(), "%s/%s", thread, file);
  const int fd = openat(folder, path.data(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return text;
  if (read(fd, text.data(), text.size() - 1) < 0) text.front() = '\0';
  close(fd);
  return text;
}

/// 'R' and so on, behind the name in brackets; ' ' if that is not known.
char stateIn(const Text& stat) {
  const char* bracket = std::strrchr(stat.data(), ')');
  return bracket && bracket[1] == ' ' ? bracket[2] : ' ';
}

/// Linux shows it in /proc; nothing of a process that is no more.
Activity activityOf(pid_t process) {
  Activity activity;
  Text path{};
  std::snprintf(path.data(), path.size(), "/proc/%d/task", process);
  const std::unique_ptr<DIR, decltype([](DIR* open) { closedir(open); })> threads(opendir(path.data()));
  if (!threads) return activity;
  const int folder = dirfd(threads.get());
  while (const dirent* thread = readdir(threads.get())) {
    if (thread->d_name[0] == '.') continue;
    const char state = stateIn(beginOf(folder, thread->d_name, "stat"));
    activity.wantsToGoOn = activity.wantsToGoOn || state == 'R' || state == 'D';
    activity.ran += 1e-9 * std::strtod(beginOf(folder, thread->d_name, "schedstat").data(), nullptr);
  }
  return activity;
}

}  // namespace

Patience::Patience(pid_t process, double seconds)
    : process_(process),
      left_(seconds),
      ran_(activityOf(process).ran),
      begin_(Clock::now()),
      looked_(begin_) {}

bool Patience::isOver() {
  const Activity activity = activityOf(process_);
  const Clock::time_point now = Clock::now();
  const double passed = std::chrono::duration<double>(now - looked_).count();
  // A thread that has ended takes what it ran with it.
  const double ran = std::clamp(activity.ran - ran_, 0.0, passed);
  left_ -= activity.wantsToGoOn ? ran : passed;
  ran_ = activity.ran;
  looked_ = now;
  return left_ <= 0 || now - begin_ > std::chrono::duration<double>(longest);
}

}  // namespace plumbline::simspark
