#pragma once
#include <chrono>
#include <cstddef>
#include <list>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "inspect/Inspector.h"

namespace plumbline::inspect {

struct DebugServerOptions {
  static constexpr int standardPort = 3300;
  std::string address = "127.0.0.1";
  int port = standardPort;  ///< 0: a free one
  std::string token;        ///< what a client's first line must be; empty: nothing, only on loopback
  bool listens = true;      ///< false: no port; only join() brings clients
};

/// The debug port: lines of text over TCP, in both directions. The length of a line, the data that waits for
/// a slow client, and the number of clients are bounded. A client beyond a limit gets an error and is closed.
/// Values of a watch are left out first, and the client gets their number. With as many clients as there may
/// be, one that has said nothing gives way to a newcomer.
class DebugServer {
public:
  static constexpr std::size_t maxLine = std::size_t{64} << 10;
  static constexpr std::size_t maxClients = 256;
  static constexpr std::size_t maxWaiting = std::size_t{1} << 20;   ///< bytes for a client
  static constexpr std::size_t dropsFrom = std::size_t{256} << 10;  ///< bytes: values are left out
  static constexpr double patience = 10;  ///< with a client that takes nothing, or says no token [s]

  /// Opens the port. Throws std::runtime_error, one line, if that is impossible.
  DebugServer(Inspector& inspector, const DebugServerOptions& options);
  ~DebugServer();
  DebugServer(const DebugServer&) = delete;
  DebugServer& operator=(const DebugServer&) = delete;

  int port() const { return port_; }
  /// A client within this program: a connected socket that speaks as the port does, without a token. The
  /// caller closes it. From any thread. Throws std::runtime_error if the system has none left.
  int join();
  std::size_t clients() const { return clients_.size(); }
  /// Serves until the descriptor is readable.
  void serve(int stopDescriptor);

private:
  using Clock = std::chrono::steady_clock;
  struct Client {
    int fd = -1, inspected = -1;  ///< inspected: -1 until it may ask
    std::string in, out;
    std::size_t sent = 0, dropped = 0;
    bool spoke = false;  ///< a line, after the token if there is one; or it belongs to the program
    bool ends = false;   ///< when all is sent
    bool dead = false;
    Clock::time_point progress{};
  };

  void listen(const DebugServerOptions& options);
  void accept();
  void takeJoined();
  Client& add(int fd);
  bool makeRoom();
  void receive(Client& client);
  void takeLines(Client& client);
  void takeLine(Client& client, std::string_view line);
  void admit(Client& client);
  /// False: it was left out.
  bool append(Client& client, std::string_view line, bool droppable);
  void end(Client& client, const std::string& error);
  void send(Client& client);
  void close(const Client& client);
  void sweep();

  Inspector& inspector_;
  std::string token_;
  int listener_ = -1, port_ = 0;
  std::list<Client> clients_;
  int joining_ = -1;  ///< readable when somebody joined
  std::mutex mutex_;
  std::vector<int> joined_;
};

}  // namespace plumbline::inspect
