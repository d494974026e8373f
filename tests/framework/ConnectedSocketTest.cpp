// A name server that does not answer holds nothing up.
#include "framework/ConnectedSocket.h"

#include <arpa/inet.h>
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

namespace {

constexpr const char* silent = "silent.example";
std::atomic<int> asked = 0, answered = 0;
std::atomic<bool> answers = false, getsSignals = false;

}  // namespace

// In place of libc's: about one name it says nothing until `answers`.
extern "C" int getaddrinfo(const char* host, const char* port, const addrinfo* hints, addrinfo** found) {
  static const auto next = reinterpret_cast<decltype(&getaddrinfo)>(dlsym(RTLD_NEXT, "getaddrinfo"));
  if (std::strcmp(host, silent) != 0 || (hints->ai_flags & AI_NUMERICHOST) != 0)
    return next(host, port, hints, found);
  sigset_t blocked;
  pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
  getsSignals = sigismember(&blocked, SIGINT) == 0;
  ++asked;
  while (!answers) usleep(1000);
  ++answered;
  return EAI_NONAME;
}

namespace plumbline {
namespace {

class ConnectedSocketTest : public testing::Test {
protected:
  ConnectedSocketTest() {
    answers = false;
    asked = answered = 0;
  }
  ~ConnectedSocketTest() override {
    answers = true;
    while (answered < asked) usleep(1000);
    close(stop);
  }
  void requestStop() const {
    const std::uint64_t one = 1;
    EXPECT_EQ(write(stop, &one, sizeof one), static_cast<ssize_t>(sizeof one));
  }
  /// Binds a socket to a free port of loopback.
  static int boundPort(int fd) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(bind(fd, reinterpret_cast<sockaddr*>(&address), size), 0);
    getsockname(fd, reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
  }
  const int stop = eventfd(0, EFD_CLOEXEC);
};

TEST_F(ConnectedSocketTest, aSilentNameServerIsGivenUpAfterTheTime) {
  const ConnectedSocket none = connectSocket(silent, 1, 0.05);
  EXPECT_EQ(none.descriptor, -1);
  EXPECT_EQ(none.problem, "no answer about its name");
  EXPECT_FALSE(getsSignals) << "a signal to that thread would wake nobody";
}

TEST_F(ConnectedSocketTest, aSilentNameServerDoesNotHoldUpTheStop) {
  std::thread stops([&] {
    while (asked == 0) usleep(1000);
    requestStop();
  });
  EXPECT_EQ(connectSocket(silent, 1, 3600, stop).problem, "Operation canceled");
  stops.join();
}

TEST_F(ConnectedSocketTest, whatTheNameServerSaysIsTheReason) {
  answers = true;
  EXPECT_EQ(connectSocket(silent, 1, 3600, stop).problem, "Name or service not known");
}

TEST_F(ConnectedSocketTest, connectsToNamesAndNumbers) {
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  const int port = boundPort(listener);
  EXPECT_EQ(connectSocket("127.0.0.1", port, 5, stop).problem, "Connection refused");
  ASSERT_EQ(listen(listener, 4), 0);
  for (const char* host : {"127.0.0.1", "localhost"}) {
    const ConnectedSocket connected = connectSocket(host, port, 5, stop);
    EXPECT_GE(connected.descriptor, 0) << host << ": " << connected.problem;
    close(connected.descriptor);
  }
  EXPECT_EQ(asked, 0) << "of another name";
  close(listener);
}

TEST_F(ConnectedSocketTest, aHostThatDoesNotAnswerIsGivenUp) {
  // Of a listener whose queue is full the kernel drops what comes.
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  const int port = boundPort(listener);
  ASSERT_EQ(listen(listener, 0), 0);
  std::vector<int> queued;
  ConnectedSocket last;
  for (int i = 0; i < 8 && last.problem.empty(); ++i) {
    last = connectSocket("127.0.0.1", port, 0.05);
    if (last.descriptor >= 0) queued.push_back(last.descriptor);
  }
  EXPECT_EQ(last.problem, "Connection timed out");
  requestStop();
  EXPECT_EQ(connectSocket("127.0.0.1", port, 3600, stop).problem, "Operation canceled");
  for (const int fd : queued) close(fd);
  close(listener);
}

}  // namespace
}  // namespace plumbline
