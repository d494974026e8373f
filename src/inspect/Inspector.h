#pragma once
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "framework/AgentDebug.h"
#include "inspect/Command.h"
#include "inspect/Outbox.h"
#include "inspect/Requests.h"

namespace plumbline::inspect {

/// Answers commands about a running agent (doc/reference/debug-protocol.md). Its own thread calls it; the
/// agent's threads interact with it at debug points and never wait. Values that are set and blocks that are
/// switched on stay so after the client disconnects.
class Inspector {
public:
  /// Takes a line without its end; `droppable`: one of many, of which a slow client may miss some. False: it
  /// was left out.
  using Send = std::function<bool(std::string_view line, bool droppable)>;
  /// Shows a drawing that was switched on by `dr`, in place of what it showed before; an empty one when it is
  /// switched off.
  using Show = std::function<void(const std::string& id, const Drawing& drawing)>;
  using Clock = std::chrono::steady_clock;

  static constexpr std::size_t maxPerClient = 256;  ///< open requests
  static constexpr std::size_t maxSet = 1024;       ///< values set and blocks switched on
  static constexpr std::size_t maxCompletions = 200;
  static constexpr double patience = 2;      ///< for a cycle to come by [s]
  static constexpr double slowPause = 0.25;  ///< a watch rests so long when its client reads too slowly [s]

  explicit Inspector(AgentDebug& agent, DebugPoints& sites = DebugPoints::sites());
  ~Inspector();
  Inspector(const Inspector&) = delete;
  Inspector& operator=(const Inspector&) = delete;

  /// Sets where drawings are shown; before this call, drawings cannot be switched on.
  void showDrawings(Show show) { show_ = std::move(show); }

  /// A client; close() ends all that it requested.
  int open(Send send);
  void close(int client);

  void command(int client, std::string_view line);
  /// Sends the answers of the agent's threads; call it every few milliseconds while busy().
  void poll(Clock::time_point now = Clock::now());
  bool busy() const { return !pending_.empty(); }

private:
  struct Client {
    Send send;
    bool json = false;
    std::size_t open = 0;
  };
  /// What a name means.
  struct Target {
    std::string name, id, part;
    DebugKind kind = DebugKind::output;
    DebugPoints* points = nullptr;  ///< null: a stopwatch
    std::shared_ptr<const Stopwatch> stopwatch{};
  };
  enum class Use { get, watch, complete, set, run };
  struct Pending {
    int client;  ///< -1: gone
    std::string tag;
    Target target;
    Use use;
    bool once = false, answered = false;
    std::shared_ptr<DebugRequest> request{};
    std::shared_ptr<ReadRequest> reads{};  ///< the same, of a watch
    Clock::time_point deadline{};
    std::string before{};  ///< of a parameter that was set
    Interval interval{};   ///< of a stopwatch
  };

  std::optional<Target> find(const std::string& name, std::string& error) const;
  void start(Pending pending, const std::function<std::shared_ptr<DebugRequest>(std::uint64_t)>& make);
  void read(int client, const Command& command, Use use);
  void set(int client, const Command& command);
  void unset(int client, const Command& command);
  void run(int client, const Command& command);
  void unwatch(int client, const Command& command);
  void list(int client, const Command& command);
  void complete(int client, const Command& command);
  void help(int client, const Command& command);
  void commands(int client, const Command& command);
  std::vector<std::string> candidates(int client, Argument argument) const;
  void timing(int client, const Command& command);
  void graph(int client, const Command& command);
  void about(int client, const Command& command);
  void providers(int client, const Command& command);

  void outcome(const Outcome& outcome);
  void value(std::uint64_t number, Pending& pending, const std::string& text);
  void readStopwatches(Clock::time_point now);
  void remove(std::uint64_t number);

  bool line(int client, const std::string& tag, const std::string& text, bool droppable = false);
  void say(int client, const std::string& tag, std::string_view key, const std::string& text);
  void finish(int client, const std::string& tag);
  void fail(int client, const std::string& tag, const std::string& error);
  void acknowledge(int client, const std::string& tag);
  void succeed(int client, const std::string& tag);
  std::vector<DebugPoints::Info> all() const;

  AgentDebug& agent_;
  DebugPoints& sites_;
  Show show_;
  std::shared_ptr<Outbox> outbox_ = std::make_shared<Outbox>();
  std::map<int, Client> clients_;
  std::map<std::uint64_t, Pending> pending_;
  int nextClient_ = 0;
  std::uint64_t nextRequest_ = 0;
};

}  // namespace plumbline::inspect
