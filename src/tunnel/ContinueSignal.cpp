#include "tunnel/ContinueSignal.h"

#include <csignal>

namespace plumbline::tunnel {

ContinueSignal::ContinueSignal() : seen_(counted_.load()) {
  struct sigaction action {};
  action.sa_handler = &ContinueSignal::count;
  sigemptyset(&action.sa_mask);
  sigaction(SIGCONT, &action, nullptr);
}

bool ContinueSignal::came() {
  const unsigned now = counted_.load();
  const bool came = now != seen_;
  seen_ = now;
  return came;
}

}  // namespace plumbline::tunnel
