#pragma once
#include <poll.h>

#include <map>
#include <span>
#include <vector>

#include "tunnel/CarriedConnection.h"

namespace plumbline::tunnel {

/// One end of what two ranks carry for each other: any number of connections, up to a bound, by frames in
/// both directions. It listens on loopback, or connects there; it knows nothing of how frames travel.
class RankLink {
public:
  static constexpr std::size_t maxConnections = 1024;

  explicit RankLink(SendFrame send) : send_(std::move(send)) {}
  ~RankLink();
  RankLink(const RankLink&) = delete;
  RankLink& operator=(const RankLink&) = delete;

  /// Connections begin at this end, at a free port of loopback, which it returns. Throws std::runtime_error.
  int listen();
  /// Connections begin at the other end and go on to this port of loopback. Nobody may listen there yet:
  /// until one got through, each is tried again for `patience` seconds.
  void connectTo(int port, double patience);

  /// Appends what to poll() for, in the order that serve() takes it back in.
  void watch(std::vector<pollfd>& watched);
  /// How many of the front of `watched` are this link's; the time is in seconds.
  std::size_t serve(std::span<const pollfd> watched, double now);
  /// Throws std::invalid_argument, one line, for what breaks the protocol.
  void take(const Frame& frame, double now);
  /// No connection begins any more.
  void stopListening();

  std::size_t connections() const { return connections_.size(); }
  /// No socket here has anything left to be sent to the other end.
  bool quiet() const;

private:
  struct Carried {
    Carried(std::uint32_t id, const SendFrame& send, double now)
        : connection(id, send), since(now), tryAt(now) {}
    CarriedConnection connection;
    double since, tryAt;  ///< when connecting began, and is tried again [s]
    bool tried = false;
    bool lastTry = false;  ///< the server was there before it was tried
  };
  void accept(double now);
  void connect(Carried& carried, double now);
  Carried& add(std::uint32_t id, double now);

  SendFrame send_;
  int listener_ = -1, port_ = 0;
  double patience_ = 0;
  bool connects_ = false;    ///< it is the end where connections go on to the server
  bool gotThrough_ = false;  ///< to the server, once
  double acceptAt_ = 0;      ///< not before [s]
  bool pauses_ = false;      ///< before that
  std::uint32_t last_ = 0;   ///< number of the newest connection
  std::map<std::uint32_t, Carried> connections_;
  std::vector<std::uint32_t> watched_;
};

}  // namespace plumbline::tunnel
