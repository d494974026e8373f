#include "MpiTransport.h"

#include <unistd.h>

#include <csignal>
#include <stdexcept>

namespace plumbline {
namespace {

constexpr int tag = 1;

volatile std::sig_atomic_t statusOfLate = 0;
void endLate(int) { _exit(statusOfLate); }

}  // namespace

void MpiTransport::check(int result, const char* what) {
  if (result == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING] = "";
  int length = 0;
  MPI_Error_string(result, text, &length);
  throw std::runtime_error(std::string("MPI cannot ") + what + ": " + text);
}

MpiTransport::MpiTransport(int& argc, char**& argv) {
  int provided = 0;  // the watchdog is a thread, and never calls MPI
  check(MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided), "start");
  check(MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN), "be asked to report errors");
  check(MPI_Comm_rank(MPI_COMM_WORLD, &rank_), "tell the rank");
  check(MPI_Comm_size(MPI_COMM_WORLD, &ranks_), "tell how many ranks there are");
  for (Receiving& one : receiving_) expect(one);
}

void MpiTransport::expect(Receiving& one) {
  check(MPI_Irecv(one.message.data(), static_cast<int>(one.message.size()), MPI_CHAR, MPI_ANY_SOURCE, tag,
                  MPI_COMM_WORLD, &one.request),
        "receive");
}

void MpiTransport::send(int to, std::string message) {
  std::deque<Sending>& queue = sending_[to];
  Sending& one = queue.emplace_back(Sending{std::move(message), MPI_REQUEST_NULL});
  check(MPI_Isend(one.message.data(), static_cast<int>(one.message.size()), MPI_CHAR, to, tag, MPI_COMM_WORLD,
                  &one.request),
        "send");
}

void MpiTransport::sweep() {
  for (auto place = sending_.begin(); place != sending_.end();) {
    std::deque<Sending>& queue = place->second;
    for (int done = 1; done != 0 && !queue.empty();) {
      check(MPI_Test(&queue.front().request, &done, MPI_STATUS_IGNORE), "send");
      if (done != 0) queue.pop_front();
    }
    place = queue.empty() ? sending_.erase(place) : std::next(place);
  }
}

bool MpiTransport::receive(int& from, std::string& message) {
  sweep();
  Receiving& one = receiving_[next_];
  int done = 0, size = 0;
  MPI_Status status{};
  check(MPI_Test(&one.request, &done, &status), "receive");
  if (done == 0) return false;
  check(MPI_Get_count(&status, MPI_CHAR, &size), "tell the size of a message");
  from = status.MPI_SOURCE;
  message.assign(one.message.data(), static_cast<std::size_t>(size));
  expect(one);
  next_ = (next_ + 1) % receiving_.size();
  return true;
}

void MpiTransport::leave(int patience, int status) {
  statusOfLate = status;
  std::signal(SIGALRM, endLate);
  alarm(static_cast<unsigned>(patience));
  for (Receiving& one : receiving_) {
    MPI_Cancel(&one.request);
    MPI_Wait(&one.request, MPI_STATUS_IGNORE);
  }
  MPI_Finalize();
  alarm(0);
}

void MpiTransport::abort(int status) {
  statusOfLate = status;
  std::signal(SIGALRM, endLate);
  alarm(1);
  MPI_Abort(MPI_COMM_WORLD, status);
  _exit(status);
}

}  // namespace plumbline
