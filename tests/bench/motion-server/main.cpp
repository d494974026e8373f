// Stand-ups and kicks of the league's types by the protocol of the thesis (Seekircher 2015, 3.1.1), on a
// SimSpark server that waits for its agents, beside the same tries on the embedded one. Writes
// build/bench/motion-server.json and .md. Environment:
//   SERVER  HOST:AGENTPORT:MONITORPORT, or server for this machine's usual ports; none: the embedded one
//   alone.
//           Without it nothing is measured.
//   TRIES   of each motion [100]
//   SEED    of the first try [1]
//   TYPES   [0 1 2 3 4]
//   MOTIONS those alone, as kickLong; the page keeps the rows that are not measured anew [all]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "ServerTries.h"
#include "framework/ReadFile.h"
#include "framework/WriteFile.h"
#include "gap/blind/BlindScore.h"
#include "simulation/ServerFixture.h"
#include "support/Environment.h"
#include "support/FigureJson.h"

namespace plumbline::bench {
namespace {

using nlohmann::json;

const char* const head =
    "{} tries each, seeds from {} on, by agents on a SimSpark server that waits for them (SERVER), "
    "and on the embedded simulator through its ports. Upright: after two seconds of walking right after "
    "the motion, within 30 degrees, with its 95 % interval (Wilson). A monitor tells poses up to two "
    "cycles late, so the same seeds do not repeat every try.\n\n";
const char* const standHead =
    "### Standing up\n\n"
    "The robot is dropped with its joints anywhere near the walk's, leans at its ankles and falls.\n\n"
    "| type | motion | server | time [ms] | upright [%] | |\n|---|---|---|---|---|---|\n";
const char* const kickHead =
    "\n### Kicks\n\n"
    "The ball lies within 1 cm of where the kick wants it. After ±: standard deviation. "
    "The height is that of the ball's centre.\n\n"
    "| type | motion | server | distance [m] | direction [deg] | height [m] | upright [%] | |\n"
    "|---|---|---|---|---|---|---|---|\n";
constexpr int tellEvery = 10;             // tries
constexpr std::size_t maxPage = 1 << 20;  // [bytes]

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviationOf(const std::vector<double>& values) {
  double sum = 0;
  const double mean = meanOf(values);
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

bool has(const training::ServerTrial& trial, const std::string& motion) {
  return std::ranges::any_of(trial.motions, [&](const auto& of) { return of.name == motion; });
}

/// The tables of all tries, by type, motion and server.
class Tables {
public:
  Tables(int tries, std::uint64_t seed, const std::string& motions) : tries_(tries), seed_(seed) {
    std::istringstream each(motions);
    for (std::string motion; each >> motion;) wanted_.insert(motion);
    if (!wanted_.empty()) keepThePage();
  }

  /// All motions of a type; what is measured is written after each of them.
  void add(const std::string& server, const training::SimSparkAddress& address, int type) {
    training::ServerTrial trial(type, address);
    for (const auto& [motion, direction] : {std::pair{"standUpFront", 1},
                                            {"standUpFrontFast", 1},
                                            {"standUpBack", -1},
                                            {"standUpBackFast", -1}})
      if (wants(motion) && has(trial, motion)) standUp(server, trial, type, motion, direction);
    for (const char* motion : {"kickShot", "kickLong"})
      if (wants(motion) && has(trial, motion)) kick(server, trial, type, motion);
  }

private:
  using Rows = std::map<std::tuple<int, std::string, std::string>, std::string>;

  bool wants(const std::string& motion) const { return wanted_.empty() || wanted_.contains(motion); }

  /// Begins with the rows and figures that the page has. Throws std::runtime_error if it is of other tries.
  void keepThePage() {
    constexpr const char* path = "doc/results/motion-server.md";
    const std::string text = std::filesystem::exists(path) ? readFile(path, maxPage) : "";
    if (text.find(fmt::format(fmt::runtime(head), tries_, seed_)) == std::string::npos)
      throw std::runtime_error(fmt::format(
          "{} does not have {} tries with seeds from {} on; with MOTIONS, give its TRIES and SEED", path,
          tries_, seed_));
    std::istringstream page(text);
    const std::regex row(R"(\| (\d) \| (\w+) \| (\w+) \| .*)"),
        figure(R"(\| `(motion-server\..*)` \| (.*) \| (.*) \|  \|  \|  \|)");
    std::smatch found;
    bool kicks = false;
    for (std::string line; std::getline(page, line);) {
      kicks = kicks || line == "### Kicks";
      if (std::regex_match(line, found, row))
        (kicks ? kicks_ : stands_)[{std::stoi(found[1]), found[2], found[3]}] = line + '\n';
      if (std::regex_match(line, found, figure))
        add(figureJson(found[1], std::stod(found[2]), found[3].str().c_str(),
                       found[3] == "ms" ? "lower" : "higher"));
    }
  }

  static std::string textOf(const Rows& rows) {
    std::string text;
    for (const auto& [key, row] : rows) text += row;
    return text;
  }

  void write() const {
    std::filesystem::create_directories("build/bench");
    writeFile("build/bench/motion-server.json", figures_.dump(1) + "\n");
    writeFile("build/bench/motion-server.md", fmt::format(fmt::runtime(head), tries_, seed_) + standHead +
                                                  textOf(stands_) + kickHead + textOf(kicks_) + "\n");
  }

  void standUp(const std::string& server, training::ServerTrial& trial, int type, const std::string& motion,
               int direction) {
    const StandUpTries of =
        tryStandUp(trial, motion, direction, tries_, seed_, progress(server, type, motion));
    stands_[{type, motion, server}] =
        fmt::format("| {} | {} | {} | {:.0f} | {} |\n", type, motion, server, meanOf(of.milliseconds),
                    upright(server, type, motion, of.up));
    figure(server, type, motion, "time", meanOf(of.milliseconds), "ms", "lower");
    write();
  }

  void kick(const std::string& server, training::ServerTrial& trial, int type, const std::string& motion) {
    const KickTries of = tryKick(trial, motion, tries_, seed_, progress(server, type, motion));
    kicks_[{type, motion, server}] =
        fmt::format("| {} | {} | {} | {:.2f} ± {:.2f} | {:.1f} ± {:.1f} | {:.2f} | {} |\n", type, motion,
                    server, meanOf(of.distance), deviationOf(of.distance), meanOf(of.direction),
                    deviationOf(of.direction), meanOf(of.height), upright(server, type, motion, of.up));
    figure(server, type, motion, "distance", meanOf(of.distance), "m", "higher");
    write();
  }

  std::string upright(const std::string& server, int type, const std::string& motion,
                      const std::vector<bool>& up) {
    const auto yes = static_cast<std::size_t>(std::ranges::count(up, true));
    const gap::Figure of = gap::share("", "", yes, up.size());
    const double share = 100.0 * static_cast<double>(yes) / static_cast<double>(up.size());
    figure(server, type, motion, "upright", share, "%", "higher");
    return fmt::format("{:.1f} | {:.0f} to {:.0f}", share, 100 * of.lower, 100 * of.upper);
  }

  void figure(const std::string& server, int type, const std::string& motion, const char* what, double value,
              const char* unit, const char* better) {
    add(figureJson(fmt::format("motion-server.type{}.{}.{}.{}", type, motion, server, what), value, unit,
                   better));
  }

  /// In the place of the one of that name.
  void add(const json& figure) {
    for (json& old : figures_)
      if (old["name"] == figure["name"]) {
        old = figure;
        return;
      }
    figures_.push_back(figure);
  }

  Progress progress(const std::string& server, int type, const std::string& motion) const {
    return [this, server, type, motion, done = 0]() mutable {
      if (++done % tellEvery == 0 || done == tries_) {
        std::printf("type %d %s on %s: %d of %d\n", type, motion.c_str(), server.c_str(), done, tries_);
        std::fflush(stdout);
      }
    };
  }

  const int tries_;
  const std::uint64_t seed_;
  std::set<std::string> wanted_;
  Rows stands_, kicks_;
  json figures_ = json::array();
};

int run() {
  const std::string server = environmentText("SERVER", "");
  if (server.empty()) {
    std::puts("no SERVER is given: nothing is measured");
    return 0;
  }
  const std::string types = environmentText("TYPES", "0 1 2 3 4");
  if (types.find_first_not_of("01234 ") != std::string::npos)
    throw std::runtime_error("TYPES=" + types + " are no robot types; write some of 0 1 2 3 4");
  Tables tables(static_cast<int>(environment("TRIES", 100)), environment("SEED", 1),
                environmentText("MOTIONS", ""));
  const auto measure = [&](const std::string& name, const training::SimSparkAddress& address) {
    std::istringstream each(types);
    for (int type = 0; each >> type;) tables.add(name, address, type);
  };
  // First the league's: without agents its clock would run on as fast as it can.
  if (server != "none") measure("server", training::SimSparkAddress::parse(server));
  test::RunningServer embedded(test::inStep());
  measure("embedded", {"127.0.0.1", embedded.agentPort(), embedded.monitorPort()});
  return 0;
}

}  // namespace
}  // namespace plumbline::bench

int main() {
  try {
    return plumbline::bench::run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "motion-server: %s\n", error.what());
    return 2;
  }
}
