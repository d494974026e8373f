#pragma once
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <stdexcept>
#include <string>

#include "simspark/Framing.h"

namespace plumbline::test {

/// One end of a connection that a test holds: listens on a free port of the loopback interface, takes one
/// client at a time and exchanges framed messages with it.
class FakeServer {
public:
  FakeServer() : listener_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (bind(listener_, reinterpret_cast<sockaddr*>(&address), size) != 0 || listen(listener_, 4) != 0)
      throw std::runtime_error("no port");
    getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
  }
  ~FakeServer() {
    drop();
    close(listener_);
  }
  FakeServer(const FakeServer&) = delete;
  FakeServer& operator=(const FakeServer&) = delete;

  int port() const { return port_; }
  void accept() {
    client_ = ::accept(listener_, nullptr, nullptr);
    reader_.reset();
  }
  void drop() {
    if (client_ >= 0) close(client_);
    client_ = -1;
  }
  /// The next message of the client, or "closed".
  std::string receive() {
    std::string_view message;
    char buffer[4096];
    while (reader_.next(message) != simspark::FrameReader::Status::message) {
      const ssize_t n = read(client_, buffer, sizeof buffer);
      if (n <= 0) return "closed";
      reader_.feed({buffer, static_cast<std::size_t>(n)});
    }
    return std::string(message);
  }
  void send(const std::string& text) {
    std::string frame;
    simspark::appendFrame(frame, text);
    [[maybe_unused]] const auto n = write(client_, frame.data(), frame.size());
  }

private:
  int listener_, client_ = -1, port_ = 0;
  simspark::FrameReader reader_{simspark::maxServerMessage};
};

}  // namespace plumbline::test
