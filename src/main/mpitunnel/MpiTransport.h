#pragma once
// Only the bindings for C: those for C++ are no longer a part of MPI.
#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <array>
#include <deque>
#include <map>
#include <string>

#include "tunnel/RankTransport.h"
#include "tunnel/TunnelFrame.h"

namespace plumbline {

/// Messages between ranks by MPI: the process belongs to MPI from here on. One at a time, used
/// by the thread that made it. Errors are std::runtime_error, one line.
class MpiTransport final : public tunnel::RankTransport {
public:
  MpiTransport(int& argc, char**& argv);
  /// Without leave() it waits for nothing: the process then ends without MPI's consent.
  ~MpiTransport() override = default;

  int rank() const override { return rank_; }
  int ranks() const override { return ranks_; }
  void send(int to, std::string message) override;
  bool receive(int& from, std::string& message) override;
  bool sentAll() const override { return sending_.empty(); }

  /// Takes leave of the other ranks, which do the same. Waits for them for at most this time [s], then the
  /// process ends with this status.
  void leave(int patience, int status);
  /// Ends all ranks and with them this process.
  [[noreturn]] void abort(int status);

private:
  struct Sending {
    std::string message;
    MPI_Request request;
  };
  struct Receiving {
    std::array<char, tunnel::maxFrame> message;
    MPI_Request request;
  };
  static void check(int result, const char* what);
  void expect(Receiving& one);
  void sweep();

  int rank_ = 0, ranks_ = 0;
  std::array<Receiving, 8> receiving_{};
  std::size_t next_ = 0;  ///< which of them a message comes into next
  std::map<int, std::deque<Sending>> sending_;
};

}  // namespace plumbline
