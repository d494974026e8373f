#pragma once
#include "tunnel/RankCommand.h"
#include "tunnel/RankLink.h"
#include "tunnel/TunnelRank.h"

namespace plumbline::tunnel {

/// Every other rank: listens at a port of loopback, where its command finds what seems to be the server.
class WorkerRank final : public TunnelRank {
public:
  /// Throws std::runtime_error where no port can be had.
  WorkerRank(RankTransport& transport, const TunnelOptions& options);

private:
  void watch(std::vector<pollfd>& watched) override { link_.watch(watched); }
  void serve(std::span<const pollfd> watched, double now) override { link_.serve(watched, now); }
  void take(int from, const Frame& frame, double now) override;
  int step(double now) override;
  RankCommand& command() override { return command_; }

  void hasEnded(int status, double now);

  int rank_;
  RankLink link_;
  RankCommand command_;
  bool ended_ = false, over_ = false, saidBye_ = false;
  bool mayLeave_ = false;  ///< all others have ended what they started, too
  double againAt_ = -1, endBy_ = -1;
};

}  // namespace plumbline::tunnel
