#include "simspark/RoboVizSender.h"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace plumbline::simspark {

RoboVizSender::RoboVizSender(const std::string& address, int port) {
  to_.sin_family = AF_INET;
  to_.sin_port = htons(static_cast<std::uint16_t>(port));
  const std::string digits = address == "localhost" ? "127.0.0.1" : address;
  if (inet_pton(AF_INET, digits.c_str(), &to_.sin_addr) != 1)
    throw std::runtime_error("drawings: " + address + " is no IPv4 address, as 127.0.0.1");
  fd_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (fd_ < 0) throw std::runtime_error("drawings: " + std::string(std::strerror(errno)));
}

RoboVizSender::~RoboVizSender() { close(fd_); }

void RoboVizSender::send(const std::vector<std::string>& datagrams) const {
  for (const std::string& datagram : datagrams)
    sendto(fd_, datagram.data(), datagram.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
           reinterpret_cast<const sockaddr*>(&to_), sizeof to_);
}

}  // namespace plumbline::simspark
