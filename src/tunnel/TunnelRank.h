#pragma once
#include <poll.h>

#include <span>
#include <string>
#include <vector>

#include "framework/StopSignal.h"
#include "tunnel/ContinueSignal.h"
#include "tunnel/RankCommand.h"
#include "tunnel/RankTransport.h"
#include "tunnel/TunnelFrame.h"
#include "tunnel/Watchdog.h"

namespace plumbline::tunnel {

struct TunnelOptions {
  std::vector<std::string> server, worker;  ///< the commands
  int port = 0;                             ///< the server's on loopback; 0: a free one, which {port} names
  double patience = 60;                     ///< for the server to open its port [s]
  double grace = 5;                         ///< for the workers to end once the server's command has [s]
  double silence = 5;                       ///< a rank that says nothing for so long has gone [s]
  bool again = false;                       ///< a worker's command that fails is started again
};

/// How a rank ends.
struct RankEnd {
  int status = 0;
  bool early = false;  ///< it or another one was asked to stop or failed: no rank is waited for
};

/// What every rank of the tunnel does: waits for sockets and messages, announces itself to the others and
/// watches whether they are, and ends all when one has to.
class TunnelRank {
public:
  virtual ~TunnelRank() = default;
  TunnelRank(const TunnelRank&) = delete;
  TunnelRank& operator=(const TunnelRank&) = delete;

  /// Until all is over. What it started has ended then, also where it throws std::runtime_error: messages do
  /// not get through, a rank has gone or sends nonsense, a command cannot start.
  RankEnd run(const StopSignal& stop);

protected:
  TunnelRank(RankTransport& transport, const TunnelOptions& options);

  virtual void watch(std::vector<pollfd>& watched) = 0;
  virtual void serve(std::span<const pollfd> watched, double now) = 0;
  virtual void take(int from, const Frame& frame, double now) = 0;
  /// Once in a while; the status once all is over, before that -1.
  virtual int step(double now) = 0;
  virtual RankCommand& command() = 0;

  void send(int to, const Frame& frame);
  void sendAll(const Frame& frame);
  [[noreturn]] void refuse(int from, const std::string& why) const;
  bool sentAll() const { return transport_.sentAll(); }

  const TunnelOptions options;

private:
  struct Peer {
    double silent = 0;     ///< [s]
    bool watched = false;  ///< from its first message on: until then it may be starting
  };
  RankEnd loop(const StopSignal& stop, Watchdog& watchdog);
  void endEarly(int status, Watchdog& watchdog);
  bool isEnding(const StopSignal& stop);
  bool takeMessages(double now);
  void watchOthers(double now);
  void pass(double most);

  RankTransport& transport_;
  std::vector<Peer> of_;  ///< by rank; those that this one talks to
  std::vector<pollfd> watched_;
  int othersStatus_ = -1;  ///< of a stop that another rank asked for
  int idle_ = 0, parent_;
  ContinueSignal continued_;
  double checked_ = -1, looked_ = -1, said_ = -1;
};

}  // namespace plumbline::tunnel
