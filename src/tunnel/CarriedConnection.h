#pragma once
#include <cstdint>
#include <string>

#include "tunnel/TunnelFrame.h"

namespace plumbline::tunnel {

/// Whether a connected socket is connected to itself, as happens on loopback where nobody listens and the
/// kernel chose just that port for this end.
bool isItsOwnPeer(int fd);

/// One end of a TCP connection that is carried: a socket here, frames to and from the other end's. Never
/// blocks. What waits for the socket is at most creditWindow: a sender that goes beyond breaks the protocol.
class CarriedConnection {
public:
  CarriedConnection(std::uint32_t id, SendFrame send) : id_(id), send_(std::move(send)) {}
  ~CarriedConnection() { close(); }
  CarriedConnection(const CarriedConnection&) = delete;
  CarriedConnection& operator=(const CarriedConnection&) = delete;

  /// Its socket, which it closes; `connecting`: not connected yet (EINPROGRESS).
  void use(int fd, bool connecting = false);
  bool hasSocket() const { return fd_ >= 0; }
  bool connected() const { return fd_ >= 0 && !connecting_; }
  int descriptor() const { return fd_; }
  /// Events for poll(); 0: the socket has to wait for frames.
  short events() const;
  /// Reads and writes the socket. One that could not be connected is closed, and may be given another.
  void serve(short revents);
  /// Takes data, end, reset and credit. Throws std::invalid_argument for more than was allowed.
  void take(const Frame& frame);
  /// Breaks it at both ends.
  void reset();

  /// Nothing more comes from this socket.
  bool quiet() const { return localEnd_ || over_; }
  /// Both ways have ended and all is passed on.
  bool over() const { return over_; }

private:
  void receive();
  void flush();
  void close();
  void closeReset();
  void checkOver();

  std::uint32_t id_;
  SendFrame send_;
  int fd_ = -1;
  bool connecting_ = false, localEnd_ = false, peerEnd_ = false, peerReset_ = false, over_ = false;
  bool shut_ = false;                     ///< the socket has been shut for writing
  std::uint32_t allowed_ = creditWindow;  ///< bytes that may still be sent to the other end
  std::uint32_t passedOn_ = 0;            ///< bytes that no credit was given back for yet
  std::string waiting_;                   ///< for the socket
};

}  // namespace plumbline::tunnel
