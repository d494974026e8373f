#pragma once
#include <deque>

#include "tunnel/RankCommand.h"
#include "tunnel/RankLink.h"
#include "tunnel/TunnelRank.h"

namespace plumbline::tunnel {

/// Rank 0: runs the server's command and connects to its port for the others. It ends with that command's
/// status, once what the command still sent is with the workers and they have ended.
class ServerRank final : public TunnelRank {
public:
  /// Throws std::runtime_error where there is no free port.
  ServerRank(RankTransport& transport, const TunnelOptions& options);

private:
  void watch(std::vector<pollfd>& watched) override;
  void serve(std::span<const pollfd> watched, double now) override;
  void take(int from, const Frame& frame, double now) override;
  int step(double now) override;
  RankCommand& command() override { return command_; }

  struct Worker {
    explicit Worker(SendFrame send) : link(std::move(send)) {}
    RankLink link;
    int status = -1;  ///< of its command; -1: has none yet
    bool left = false;
  };
  void checkWorkers() const;

  int port_;
  RankCommand command_;
  std::deque<Worker> workers_;  ///< of rank 1 on
  int status_ = -1;
  double endedAt_ = -1, overAt_ = -1, byeAt_ = -1;
};

}  // namespace plumbline::tunnel
