// Several clients at once on the agents' and the monitors' port, over sockets.
#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <array>

#include "fuzz/Readers.h"
#include "simspark/Framing.h"
#include "simulation/Simulation.h"
#include "simulation/server/AgentPort.h"
#include "simulation/server/LimitedLog.h"
#include "simulation/server/MonitorPort.h"

namespace plumbline::fuzz {
namespace {

using namespace simulation;

constexpr int portCycles = 20;

/// A client's end; bytes that do not fit into the socket are lost, as on a network that breaks down.
class PortClient {
public:
  ~PortClient() { leave(); }
  void connect(int port) {
    leave();
    fd_ = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ::connect(fd_, reinterpret_cast<sockaddr*>(&address), sizeof address);
  }
  void send(std::string_view bytes) {
    if (fd_ >= 0) ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }
  void read() {
    std::array<char, 1 << 14> bytes;
    if (fd_ >= 0)
      while (recv(fd_, bytes.data(), bytes.size(), 0) > 0) {
      }
  }
  /// By a reset, so that no port of this machine is kept.
  void leave() {
    if (fd_ < 0) return;
    const linger now{1, 0};
    setsockopt(fd_, SOL_SOCKET, SO_LINGER, &now, sizeof now);
    close(fd_);
    fd_ = -1;
  }

private:
  int fd_ = -1;
};

struct Ports {
  SimulationConfig config;
  Simulation simulation{config};
  LimitedLog log{[](const std::string& line) { logged(line); }};  // as the server's
  AgentPort agents{{.port = 0, .sync = true, .syncTimeout = 0.0},
                   simulation,
                   [this](const std::string& line) { log(line); }};
  MonitorPort monitors{monitorConfig(), simulation, [this](const std::string& line) { log(line); }};
  std::array<PortClient, 6> clients;  ///< the last two are monitors

  static MonitorPort::Config monitorConfig() {
    MonitorPort::Config any;
    any.port = 0;
    return any;
  }
  static void logged(const std::string& line) {
    for (const char c : line)
      require(static_cast<unsigned char>(c) >= ' ', "a log line with control characters");
  }

  void serve() {
    std::vector<pollfd> descriptors;
    agents.watch(descriptors);
    const std::size_t of = descriptors.size();
    monitors.watch(descriptors);
    poll(descriptors.data(), descriptors.size(), 0);
    agents.serve(descriptors.data());
    monitors.serve(descriptors.data() + of);
  }

  void cycle() {
    for (int i = 0; i < 3; ++i) serve();  // those who came, then what they said
    monitors.carryOut();
    if (const auto reset = monitors.takeReset()) agents.restarted(simulation.restart(reset->seed));
    agents.dropBroken();  // a trainer may have removed players
    agents.carryOut();
    agents.sendSenses();
    simulation.step();
    if (monitors.due() || monitors.owe()) monitors.sendState(monitors.due());
    agents.dropBroken();
    monitors.dropBroken();
    for (PortClient& client : clients) client.read();
  }
};

/// Lines: client 0 to 5, then "+" comes, "-" goes, "!" bytes as they are, else a framed message; "." a cycle.
void ports(std::string_view bytes) {
  Ports server;
  int cycles = 0;
  for (std::size_t begin = 0; begin < bytes.size() && cycles < portCycles;) {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    std::string_view line = bytes.substr(begin, end - begin);
    begin = end + 1;
    if (line.starts_with('.')) {
      server.cycle();
      ++cycles;
    }
    if (line.size() < 2 || line[0] < '0' || line[0] > '5') continue;
    const auto who = static_cast<std::size_t>(line[0] - '0');
    PortClient& client = server.clients[who];
    line.remove_prefix(1);
    std::string frame;
    if (line == "+")
      client.connect(who < 4 ? server.agents.port() : server.monitors.port());
    else if (line == "-")
      client.leave();
    else if (line[0] == '!')
      client.send(line.substr(1));
    else
      client.send((simspark::appendFrame(frame, line), frame));
  }
  for (PortClient& client : server.clients) client.leave();
  for (int i = 0; i < 2; ++i) server.cycle();
  require(server.agents.numAgents() == 0, "an agent that nobody has");
}

std::vector<std::string> portsSeeds() {
  const std::string two =
      "0+\n1+\n4+\n0(scene rsg/agent/nao/nao_hetero.rsg 0)\n1(scene rsg/agent/nao/nao_hetero.rsg 4)\n.\n"
      "0(init (unum 1)(teamname A))\n1(init (unum 1)(teamname B))\n.\n0(beam -1 0 0)(syn)\n1(syn)\n.\n";
  return {
      two + "0(he1 2)(syn)\n1-\n.\n4(playMode PlayOn)\n.\n",
      two + "2+\n2(scene rsg/agent/nao/nao_hetero.rsg 0)\n.\n2(init (unum 1)(teamname A))\n.\n2-\n2+\n.\n",
      two +
          "3+\n3!\x7f\xff\xff\xff\n.\n5+\n5(kill (unum 1)(team Left))(reqfullstate)\n.\n5(clock)(pause)\n.\n",
      "0+\n0!(syn)\n.\n0-\n4+\n4(repos)(init)(killsim)\n.\n"};
}

const Registered portsTarget({"ports", ports, portsSeeds, 240});

}  // namespace
}  // namespace plumbline::fuzz
