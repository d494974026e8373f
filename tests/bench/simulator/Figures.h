#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace plumbline::bench {

using nlohmann::json;

/// Another's figure to compare with; null: nothing is known.
struct Peer {
  json value = nullptr;
  std::string name = "rcssserver3d 0.7.3";
};

/// The figures of a benchmark, as scripts/run_bench.sh reads them.
class Figures {
public:
  void add(const std::string& name, double value, const std::string& unit, const std::string& better,
           json target = nullptr, const Peer& peer = Peer()) {
    json figure = {{"name", "simulator." + name}, {"value", value}, {"unit", unit}, {"better", better}};
    if (!target.is_null()) figure["target"] = std::move(target);
    if (!peer.value.is_null()) {
      figure["peer"] = peer.name;
      figure["peer_value"] = peer.value;
    }
    all.push_back(std::move(figure));
  }
  json all = json::array();
};

// What the benchmark consists of.
/// Server and agents through sockets, in step, with a monitor: cost per number of robots.
void measureCrowds(Figures& figures, int cycles);
/// Programs of their own as agents: one in step, and two teams of eleven in real time.
void measureGames(Figures& figures);
/// What the time of a cycle goes to, in this process, for 1 and 22 robots; resets.
void measureParts(Figures& figures);
/// Reading and writing messages.
void measureWire(Figures& figures);

/// CPU time of this process [us].
double cpuMicroseconds();

/// Its cost of one call [us].
template <typename Call>
double cpuPerCall(int calls, const Call& call) {
  const double before = cpuMicroseconds();
  for (int i = 0; i < calls; ++i) call();
  return (cpuMicroseconds() - before) / calls;
}

}  // namespace plumbline::bench
