#include "framework/ThreadPriority.h"

#include <pthread.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "framework/ModulesConfig.h"

namespace plumbline {

std::string applyThreadPriority(int priority, int highest) {
  if (priority == ThreadConfig::maxPriority) {
    sched_param parameters{};
    parameters.sched_priority = 1;
    const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
    return error == 0 ? "" : std::string("no real-time scheduling: ") + std::strerror(error);
  }
  if (priority >= highest) return "";
  // On Linux, nice belongs to the thread.
  const auto thread = static_cast<id_t>(syscall(SYS_gettid));
  errno = 0;
  const int base = getpriority(PRIO_PROCESS, thread);
  if (errno == 0 && setpriority(PRIO_PROCESS, thread, std::min(base + highest - priority, 19)) == 0)
    return "";
  return std::string("nice not set: ") + std::strerror(errno);
}

}  // namespace plumbline
