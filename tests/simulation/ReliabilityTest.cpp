// What comes and goes, and what is slow, leaves no trace and holds up nobody.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <random>

#include "ServerFixture.h"

namespace plumbline::simulation {
namespace {

using simspark::Connection;
using test::inStep;
using test::RunningServer;
using test::TestAgent;

/// A client that may stop at any point of its life.
class Guest {
public:
  bool here() const { return connection_.connected(); }
  void come(int port, int type, std::string team, int unum) {
    ASSERT_EQ(connection_.connect("127.0.0.1", port), "");
    team_ = std::move(team);
    unum_ = unum;
    messages_ = 0;
    asked_ = false;
    this->type_ = type;
  }
  /// Takes part in a cycle: reads, if there is something to read, and answers.
  void play() {
    if (!asked_) {
      connection_.send("(scene rsg/agent/nao/nao_hetero.rsg " + std::to_string(type_) + ")(syn)");
      asked_ = true;
      return;
    }
    std::string_view text;
    // A new robot's first cycle has no message; everybody else's comes soon.
    if (connection_.receive(text, messages_ == 0 ? 0.001 : 0.02) != Connection::Status::message) return;
    constexpr std::string_view clock = "(time (now ";
    if (text.starts_with(clock)) time_ = std::max(time_, std::atof(text.data() + clock.size()));
    ++messages_;
    std::string answer =
        messages_ == 1 ? "(init (unum " + std::to_string(unum_) + ")(teamname " + team_ + "))" : "";
    if (messages_ == 3)
      answer += "(beam -" + std::to_string(1 + unum_) + " " + std::to_string(unum_ - 6) + " 0)";
    connection_.send(answer +
                     (messages_ % 20 < 10 ? "(rle4 -0.5)(lle4 0.5)(syn)" : "(rle4 0.5)(lle4 -0.5)(syn)"));
  }
  double time() const { return time_; }  ///< of the server, when it was last heard of [s]

  /// Goes in one of the ways in which clients go.
  void vanish(unsigned how) {
    switch (how % 4) {
      case 0:  // without a word
        break;
      case 1: {  // with what it has not read: the connection is reset
        linger hard{1, 0};
        setsockopt(connection_.descriptor(), SOL_SOCKET, SO_LINGER, &hard, sizeof hard);
        break;
      }
      case 2:  // in the middle of a message
        EXPECT_EQ(::send(connection_.descriptor(), "\0\0\0\x20(he1", 8, MSG_NOSIGNAL), 8);
        break;
      default:  // with nonsense
        connection_.send("(((");
    }
    connection_.close();
  }

private:
  Connection connection_;
  std::string team_;
  int unum_ = 0, type_ = 0, messages_ = 0;
  bool asked_ = false;
  double time_ = 0;
};

std::size_t openFiles() {
  std::size_t n = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) ++n;
  return n;
}

double residentMegabytes() {
  malloc_trim(0);
  std::ifstream in("/proc/self/statm");
  long all = 0, resident = 0;
  in >> all >> resident;
  return static_cast<double>(resident * sysconf(_SC_PAGESIZE)) / 1e6;
}

/// 22 clients, each here for some time and away for longer, four of them on average.
class Guests {
public:
  Guests(int port, unsigned seed) : port_(port), random_(seed) {}
  void cycle() {
    for (std::size_t i = 0; i < guests_.size(); ++i) {
      Guest& guest = guests_[i];
      time = std::max(time, guest.time());
      const auto dice = random_() % 1000;
      if (!guest.here() && dice < 2) {
        guest.come(port_, static_cast<int>(random_() % 5), i < 11 ? "Red" : "Blue",
                   static_cast<int>(i % 11) + 1);
        ++came;
      }
      if (guest.here()) guest.play();
      if (guest.here() && random_() % 1000 < 12) guest.vanish(random_());
    }
  }
  /// All come and stay.
  void allCome() {
    for (std::size_t i = 0; i < guests_.size(); ++i)
      if (!guests_[i].here())
        guests_[i].come(port_, static_cast<int>(i % 5), i < 11 ? "Red" : "Blue",
                        static_cast<int>(i % 11) + 1);
  }
  void playOn() {
    for (Guest& guest : guests_) guest.play();
  }
  void allGo() {
    for (Guest& guest : guests_)
      if (guest.here()) guest.vanish(0);
  }
  int came = 0;
  double time = 0;  ///< of the server [s]

private:
  int port_;
  std::mt19937 random_;
  std::array<Guest, 22> guests_;
};

void waitUntilEmpty(simspark::MonitorClient& monitor) {
  const bool emptied = comesTrue([&] {
    monitor.send("(reqfullstate)");
    EXPECT_EQ(monitor.receive(farOff), Connection::Status::message);
    return monitor.scene().robots.empty();
  });
  EXPECT_TRUE(emptied) << monitor.scene().robots.size() << " robots are left";
}

/// Ten simulated minutes; under sanitizers half a one, as what they look for shows in it as well.
TEST(Reliability, twoAndTwentyThatConnectAndVanishLeaveNothing) {
#if defined(__SANITIZE_ADDRESS__)
  constexpr double seconds = 30;
#else
  constexpr double seconds = 600;
#endif
  const std::size_t filesBefore = openFiles();
  {
    ServerConfig config = inStep(1);
    config.agents.halfTimeout = 0.05;
    config.simulation.rules.kickOff.after = 1;
    config.monitors.interval = 5;
    RunningServer server(config);
    simspark::MonitorClient monitor;
    ASSERT_EQ(monitor.connect("127.0.0.1", server.monitorPort()), "");
    Guests guests(server.agentPort(), 5);
    double warm = 0;
    std::size_t mostRobots = 0;
    while (guests.time < seconds) {
      guests.cycle();
      ASSERT_TRUE(monitor.poll()) << monitor.error();
      mostRobots = std::max(mostRobots, monitor.scene().robots.size());
      if (warm == 0 && guests.time > 0.2 * seconds) warm = residentMegabytes();
    }
    guests.allGo();
    waitUntilEmpty(monitor);
    const double grown = residentMegabytes() - warm;
    std::printf(
        "%d connections in %.0f simulated seconds, at most %zu robots at once; memory grew by %.1f MB\n",
        guests.came, seconds, mostRobots, grown);
    EXPECT_GT(guests.came, static_cast<int>(seconds));
    EXPECT_GE(mostRobots, 5u);
#if !defined(__SANITIZE_ADDRESS__)
    EXPECT_LT(grown, 4) << "a robot takes 0.3 MB: " << guests.came << " of them would be seen";
#endif
    // All numbers of both teams are free again, and robots take part.
    const std::size_t logged = server.log().size();
    guests.allCome();
    const auto numbered = [&] {
      const auto& robots = monitor.scene().robots;
      return std::count_if(robots.begin(), robots.end(), [](const auto& robot) { return robot.unum > 0; });
    };
    for (int i = 0; i < 400 && numbered() < 22; ++i) {
      guests.playOn();
      ASSERT_TRUE(monitor.poll());
    }
    EXPECT_EQ(numbered(), 22);
    for (const char* team : {"Red ", "Blue "})
      for (int unum = 1; unum <= 11; ++unum)
        EXPECT_NE(server.log().find(team + std::to_string(unum) + ") plays", logged), std::string::npos)
            << team << unum;
    guests.allGo();
  }
  EXPECT_EQ(openFiles(), filesBefore);
}

/// The clock stands when nobody is left; what monitors saw last must not stay on their screens.
TEST(Reliability, whoLeavesLastIsNotShownAnyMore) {
  ServerConfig config = inStep(1);
  config.monitors.interval = 50;
  RunningServer server(config);
  simspark::MonitorClient monitor, viewer;
  ASSERT_EQ(monitor.connect("127.0.0.1", server.monitorPort()), "");
  ASSERT_EQ(viewer.connect("127.0.0.1", server.monitorPort()), "");
  viewer.send(simspark::ViewerCommand{0.001});
  {
    TestAgent agent(server.agentPort(), 0, "Red", 1);
    for (int i = 0; i < 200 && (monitor.scene().robots.empty() || viewer.scene().robots.empty()); ++i) {
      agent.play(1);
      ASSERT_TRUE(monitor.poll() && viewer.poll());
    }
  }
  for (auto* watcher : {&monitor, &viewer}) {
    ASSERT_EQ(watcher->scene().robots.size(), 1u);
    while (!watcher->scene().robots.empty()) ASSERT_EQ(watcher->receive(farOff), Connection::Status::message);
  }
}

/// In real time nobody is waited for: one agent answers every message, one every 25th, one reads nothing at
/// all.
TEST(Reliability, aSlowAgentInRealTimeSlowsNobody) {
  ServerConfig config;
  config.simulation.seed = 1;
  RunningServer server(config);
  TestAgent quick(server.agentPort(), 0, "Red", 1), slow(server.agentPort(), 1, "Red", 2),
      deaf(server.agentPort(), 2, "Red", 3);
  quick.play(10);
  constexpr int cycles = 100;  // two seconds
  double last = 0, longest = 0;
  int missing = 0, slowAnswers = 0;
  const double start = steadySeconds();
  double before = start;
  for (int i = 0; i < cycles; ++i) {
    const std::string text = quick.play(1);
    ASSERT_EQ(text.find("gone"), std::string::npos);
    simspark::ServerMessage message;
    ASSERT_FALSE(simspark::parseServerMessage(text.substr(0, text.find('\n')), message));
    if (last > 0 && message.time - last > 0.021) ++missing;
    last = message.time;
    const double now = steadySeconds();
    longest = std::max(longest, now - before);
    before = now;
    if (i % 25 == 24) {
      slow.play(1);
      ++slowAnswers;
    }
  }
  const double seconds = steadySeconds() - start;
  std::printf(
      "%d cycles in %.2f s beside an agent that answered %d and one that read none; longest pause %.0f ms\n",
      cycles, seconds, slowAnswers, 1000 * longest);
  EXPECT_EQ(missing, 0) << "the quick agent gets every message";
  EXPECT_GE(seconds, 1.8);
  // How much later than two seconds is the machine's affair: one that is short of time makes everybody late.
}

}  // namespace
}  // namespace plumbline::simulation
