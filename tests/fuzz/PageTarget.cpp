// Requests of browsers: HTTP and WebSocket, over sockets.
#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <array>

#include "fuzz/Readers.h"
#include "pages/PageServer.h"
#include "pages/PageSource.h"

namespace plumbline::fuzz {
namespace {

constexpr std::size_t longestMessage = 1000;

/// Says back what a page says, up to a limit.
class Echo final : public pages::PageSource {
  class Session final : public pages::PageSession {
  public:
    bool receive(std::string_view message) override {
      require(message.size() <= longestMessage, "a message longer than is taken");
      said_ = message;
      return message != "bye";
    }
    Kind next(std::string& message) override {
      if (said_.empty()) return Kind::nothing;
      message += said_;
      said_.clear();
      return Kind::binary;
    }

  private:
    std::string said_;
  };

public:
  std::unique_ptr<pages::PageSession> open() override { return std::make_unique<Session>(); }
  std::size_t maxMessage() const override { return longestMessage; }
  void onNews(std::function<void()>) override {}
};

pages::PageServer& pageServer() {
  static Echo echo;
  static pages::PageServer one = [] {
    pages::PageServer::Config config;
    config.port = 0;
    config.folder = scratchFolder() + "/page";
    scratchFile("page/index.html", "<p>a page</p>");
    scratchFile("secret.txt", "nobody may read this");
    return pages::PageServer(config, echo);
  }();
  static const bool started = (one.start(), true);
  require(started, "no server");
  return one;
}

/// What the server answers to these bytes and the end of the client's stream, or what came within half a
/// second of silence.
std::string answerOf(std::string_view bytes) {
  const int fd = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(pageServer().port()));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  std::string text;
  if (connect(fd, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) {
    send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    shutdown(fd, SHUT_WR);
    std::array<char, 4096> piece;
    pollfd ready{fd, POLLIN, 0};
    for (ssize_t n = 1; n > 0 && text.size() < 100000 && poll(&ready, 1, 500) == 1;) {
      n = recv(fd, piece.data(), piece.size(), 0);
      if (n > 0) text.append(piece.data(), static_cast<std::size_t>(n));
    }
  }
  const linger now{1, 0};
  setsockopt(fd, SOL_SOCKET, SO_LINGER, &now, sizeof now);
  close(fd);
  return text;
}

void pageRequest(std::string_view bytes) {
  require(answerOf(bytes).find("nobody may read this") == std::string::npos,
          "a file beside the page's folder");
}

std::vector<std::string> pageRequestSeeds() {
  using std::string_literals::operator""s;
  const std::string host = "Host: 127.0.0.1\r\n";
  const std::string upgrade =
      "GET / HTTP/1.1\r\n" + host +
      "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
      "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Protocol: plumbline\r\n\r\n";
  return {"GET / HTTP/1.1\r\n" + host + "\r\n",
          "GET /../secret.txt HTTP/1.1\r\n" + host + "\r\n",
          "GET /%2e%2e/secret.txt HTTP/1.0\r\n\r\n",
          "POST /x HTTP/1.1\r\n" + host + "Content-Length: 99999999999\r\n\r\nabc",
          upgrade,
          upgrade + "\x81\x85\1\2\3\4\x69\x67\x6f\x68\x6e"s + "\x88\x80\1\2\3\4"s,
          upgrade + "\x01\xfe\x7f\xff\0\0\0\0abc"s,
          upgrade + "\x82\xff\x7f\xff\xff\xff\xff\xff\xff\xff\0\0\0\0"s};
}

const Registered pageRequestTarget({"pageRequest", pageRequest, pageRequestSeeds, 120});

}  // namespace
}  // namespace plumbline::fuzz
