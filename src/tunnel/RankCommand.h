#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simspark/ChildProcess.h"

namespace plumbline::tunnel {

/// What a rank runs beside the tunnel: a command whose arguments may have {port} and {rank} in them. It has
/// both in its environment too, as MPITUNNEL_PORT and MPITUNNEL_RANK, and nothing of MPI's: it is no rank.
class RankCommand {
public:
  RankCommand(std::vector<std::string> command, int port, int rank);

  /// Throws std::runtime_error "cannot start NAME: REASON".
  void start();
  bool started() const { return child_ != nullptr; }
  /// Exit status, or 128 + signal; empty while it runs.
  std::optional<int> status();
  /// Tells it and what it started to end, and does not wait.
  void terminate();
  /// Ends it and what it started itself: SIGTERM, after so long [s] SIGKILL.
  void stop(double patience);
  const std::string& name() const { return command_.front(); }

private:
  std::vector<std::string> command_;
  simspark::ChildSettings settings_;
  std::unique_ptr<simspark::ChildProcess> child_;
};

}  // namespace plumbline::tunnel
