#include "web/WebServer.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "support/FarOff.h"

namespace plumbline::web {
namespace {

namespace fs = std::filesystem;

/// Remembers what pages asked for.
struct TestFeed : Feed {
  void command(const PageCommand& command) override {
    const std::lock_guard lock(mutex);
    if (const auto* seek = std::get_if<Seek>(&command)) times.push_back(seek->time);
  }
  std::vector<double> all() {
    const std::lock_guard lock(mutex);
    return times;
  }
  std::mutex mutex;
  std::vector<double> times;
};

class Client {
public:
  explicit Client(int port) : fd_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval patience{10, 0};
    setsockopt(fd_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    EXPECT_EQ(connect(fd_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  ~Client() { close(fd_); }
  void send(const std::string& text) {
    EXPECT_EQ(::send(fd_, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
  }
  /// Reads until so many bytes are there or the other side closes.
  std::string read(std::size_t size) {
    char buffer[1 << 16];
    for (ssize_t n; received_.size() < size && (n = recv(fd_, buffer, sizeof buffer, 0)) > 0;)
      received_.append(buffer, static_cast<std::size_t>(n));
    return std::exchange(received_, {});
  }
  /// Reads the answer's headers; what comes after stays.
  std::string headers() {
    char byte;
    std::string text;
    while (!text.ends_with("\r\n\r\n") && recv(fd_, &byte, 1, 0) == 1) text += byte;
    return text;
  }
  /// A WebSocket message of the server, short or with 16 bits of length.
  std::string message() {
    const std::string head = exactly(2);
    if (head.size() < 2) return "closed";
    std::size_t length = static_cast<unsigned char>(head[1]);
    if (length == 126) {
      const std::string more = exactly(2);
      length = 256u * static_cast<unsigned char>(more.at(0)) + static_cast<unsigned char>(more.at(1));
    }
    return exactly(length);
  }
  /// Sends a WebSocket text (masked with zeros).
  void sendText(const std::string& text) {
    std::string frame = "\x81";
    if (text.size() < 126) {
      frame += static_cast<char>(0x80 | text.size());
    } else {
      frame += static_cast<char>(0x80 | 126);
      frame += static_cast<char>(text.size() >> 8);
      frame += static_cast<char>(text.size() & 255);
    }
    send(frame + std::string(4, '\0') + text);
  }

private:
  std::string exactly(std::size_t size) {
    std::string text(size, '\0');
    std::size_t have = 0;
    for (ssize_t n; have < size && (n = recv(fd_, text.data() + have, size - have, 0)) > 0;)
      have += static_cast<std::size_t>(n);
    text.resize(have);
    return text;
  }
  int fd_;
  std::string received_;
};

class WebServerTest : public ::testing::Test {
protected:
  WebServerTest() {
    folder = fs::temp_directory_path() / ("web" + std::to_string(getpid()));
    fs::create_directories(folder / "page");
    std::ofstream(folder / "page" / "index.html") << "<p>the page";
    std::ofstream(folder / "secret.txt") << "secret";
  }
  ~WebServerTest() override { fs::remove_all(folder); }
  WebServer::Config config(const std::string& token = "") {
    WebServer::Config config;
    config.port = 0;
    config.folder = folder / "page";
    config.token = token;
    return config;
  }
  static std::string upgrade(const std::string& host, const std::string& origin,
                             const std::string& path = "/") {
    return "GET " + path + " HTTP/1.1\r\nHost: " + host +
           "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n" +
           (origin.empty() ? "" : "Origin: " + origin + "\r\n") +
           "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: plumbline\r\n"
           "Sec-WebSocket-Version: 13\r\n\r\n";
  }
  bool admitted(WebServer& server, const std::string& request) {
    Client client(server.port());
    client.send(request);
    return client.headers().starts_with("HTTP/1.1 101");
  }

  fs::path folder;
  Broadcast broadcast;
  TestFeed feed;
};

TEST_F(WebServerTest, servesItsFolderAndNothingElse) {
  WebServer server(config(), broadcast);
  server.start(feed);
  const auto get = [&](const std::string& path) {
    Client client(server.port());
    client.send("GET " + path + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
    return client.read(1 << 20);
  };
  const std::string page = get("/");
  EXPECT_TRUE(page.starts_with("HTTP/1.1 200")) << page;
  EXPECT_TRUE(page.ends_with("<p>the page")) << page;
  EXPECT_NE(page.find("content-security-policy: default-src 'none'"), std::string::npos);
  for (const char* path :
       {"/../secret.txt", "/%2e%2e/secret.txt", "/x/../../secret.txt", "//../secret.txt", "/none"})
    EXPECT_EQ(get(path).find("secret\n"), std::string::npos) << path;
  EXPECT_FALSE(get("/../secret.txt").starts_with("HTTP/1.1 200"));
}

TEST_F(WebServerTest, onlyItsOwnPagesMayConnect) {
  WebServer server(config(), broadcast);
  server.start(feed);
  const std::string port = ':' + std::to_string(server.port());
  EXPECT_TRUE(admitted(server, upgrade("localhost" + port, "http://localhost" + port)));
  EXPECT_TRUE(admitted(server, upgrade("127.0.0.1" + port, "")));
  EXPECT_FALSE(admitted(server, upgrade("localhost" + port, "http://elsewhere.example")));
  EXPECT_FALSE(admitted(server, upgrade("elsewhere.example" + port, "http://elsewhere.example" + port)));
  EXPECT_FALSE(admitted(server, upgrade("elsewhere.example" + port, "")));
  // A name that only looks like the loopback interface may lead anywhere.
  for (const char* host : {"127.evil.example", "127.0.0.1.evil.example", "127.0.0.1@evil.example"})
    EXPECT_FALSE(admitted(server, upgrade(host + port, std::string("http://") + host + port))) << host;
}

TEST_F(WebServerTest, aTokenIsAskedFor) {
  WebServer server(config("sesame"), broadcast);
  server.start(feed);
  EXPECT_TRUE(admitted(server, upgrade("robot.example", "http://robot.example", "/?token=sesame")));
  EXPECT_FALSE(admitted(server, upgrade("robot.example", "http://robot.example", "/?token=sesam")));
  EXPECT_FALSE(admitted(server, upgrade("robot.example", "http://robot.example", "/?token=sesamE")));
  EXPECT_FALSE(admitted(server, upgrade("robot.example", "http://robot.example")));
}

TEST_F(WebServerTest, tellsTheLastOfEachChannelAndTakesCommands) {
  broadcast.publish(Channel::geometry, "geometry");
  broadcast.publish(Channel::game, "old");
  broadcast.publish(Channel::game, std::string(300, 'g'));
  WebServer server(config(), broadcast);
  server.start(feed);
  Client client(server.port());
  client.send(upgrade("localhost", ""));
  ASSERT_TRUE(client.headers().starts_with("HTTP/1.1 101"));
  EXPECT_EQ(client.message(), "geometry");
  EXPECT_EQ(client.message(), std::string(300, 'g'));
  broadcast.publish(Channel::frame, "frame");
  EXPECT_EQ(client.message(), "frame");

  client.sendText(R"({"do":"seek","time":4})");
  client.sendText("garbage");
  client.sendText(R"({"do":"seek","time":5})");
  EXPECT_TRUE(comesTrue([&] { return feed.all().size() >= 2; }));
  EXPECT_EQ(feed.all(), (std::vector<double>{4, 5}));
  client.sendText(std::string(6000, 'x'));
  EXPECT_EQ(client.message().substr(0, 6), "closed") << "too long a command";
}

TEST_F(WebServerTest, aPageThatDoesNotReadHoldsUpNobody) {
  WebServer server(config(), broadcast);
  server.start(feed);
  Client deaf(server.port()), good(server.port());
  for (Client* client : {&deaf, &good}) {
    client->send(upgrade("localhost", ""));
    ASSERT_TRUE(client->headers().starts_with("HTTP/1.1 101"));
  }
  for (int i = 0; i < 2000; ++i)
    broadcast.publish(Channel::frame, std::string(60000, static_cast<char>('a' + i % 26)));
  broadcast.publish(Channel::frame, "last");
  std::string message;
  for (int i = 0; i < 2500 && message != "last"; ++i) message = good.message();
  EXPECT_EQ(message, "last");
}

TEST_F(WebServerTest, portInUseIsSaid) {
  const WebServer first(config(), broadcast);
  WebServer::Config second = config();
  second.port = first.port();
  Broadcast other;
  try {
    const WebServer server(second, other);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), "cannot listen on 127.0.0.1:" + std::to_string(first.port()) +
                                " for the page; is the port in use? Choose another or 0");
  }
  second.anyPort = true;
  const WebServer server(second, other);
  EXPECT_NE(server.port(), first.port());
}

}  // namespace
}  // namespace plumbline::web
