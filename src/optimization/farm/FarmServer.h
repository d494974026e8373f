#pragma once
#include <chrono>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "optimization/farm/Dispatcher.h"
#include "optimization/farm/Journal.h"
#include "optimization/farm/LineSocket.h"
#include "optimization/farm/Messages.h"

namespace plumbline::farm {

struct FarmOptions {
  std::string address = "127.0.0.1";
  int port = 0;       ///< 0: a free one
  std::string token;  ///< what clients have to say; empty: nothing, on loopback only
  DispatchOptions dispatch{};
  std::size_t maxClients = 1024;  ///< of more, one that has said nothing gives way to a newcomer
  double helloPatience = 10;      ///< for a client that has said nothing [s]
};

/// What the server has seen since it began.
struct FarmProgress {
  std::int64_t trials = 0, runs = 0, dropped = 0;
  double seconds = 0, busySeconds = 0;      ///< busy: of all workers together
  std::map<std::string, double> figures{};  ///< of the trial that cost least in the last results
  double lastCost = 0;                      ///< mean of the last hundred or so, slowly forgotten
};

/// A worker that is there.
struct WorkerReport {
  std::string name;
  bool busy = false;
  std::int64_t answers = 0;
  double seconds = 0;  ///< since it was given its trial, or since it came
};

/// Distributes a search over TCP; no worker waits for another one. A client that breaks the protocol or sends
/// wrong results is dropped; its trial goes to another.
class FarmServer {
public:
  /// Opens the port. Throws std::runtime_error, one line. journal may be null: nothing is kept then.
  FarmServer(Search& search, Journal* journal, Welcome welcome, const FarmOptions& options);
  ~FarmServer();
  FarmServer(const FarmServer&) = delete;
  FarmServer& operator=(const FarmServer&) = delete;

  int port() const { return port_; }
  /// Serves until the search is over and all workers know it (true), or the descriptor is readable (false).
  /// tick is called about ten times a second.
  bool serve(int stopDescriptor, const std::function<void()>& tick = {});

  std::size_t workers() const { return dispatcher_.workers(); }
  std::size_t busy() const { return dispatcher_.busy(); }
  const DispatchCounts& counts() const { return dispatcher_.counts(); }
  const FarmProgress& progress() const { return progress_; }
  std::vector<WorkerReport> workerReports() const;
  /// Called with each result before the search learns of it; without costs: given up.
  void onResult(std::function<void(std::span<const double>)> take) { onResult_ = std::move(take); }
  /// The status as JSON in one line.
  std::string status() const;

private:
  using Clock = std::chrono::steady_clock;
  struct Client {
    LineSocket socket;
    double since;
    int worker = -1;  ///< -1: has not identified itself yet
    std::string name{};
    double gaveAt = 0;
    std::int64_t answers = 0;
    bool works = false, ends = false;
  };

  double now() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
  void accept();
  bool makeRoom();
  void takeLines(Client& client);
  void hello(Client& client, const std::string& line);
  void answer(Client& client, const std::string& line);
  void giveWork();
  void refuse(Client& client, const std::string& why);
  void sweep();
  void record(const Trial& trial, std::span<const double> costs, int worker);

  Search& search_;
  Journal* journal_;
  Welcome welcome_;
  FarmOptions options_;
  Dispatcher dispatcher_;
  int listener_ = -1, port_ = 0;
  std::list<Client> clients_;
  FarmProgress progress_;
  std::function<void(std::span<const double>)> onResult_;
  Clock::time_point begin_ = Clock::now();
  double synced_ = 0;
  std::map<std::string, double> figures_;  ///< of the answer that is being taken
  std::string answerer_;
  double answerSeconds_ = 0;
};

}  // namespace plumbline::farm
