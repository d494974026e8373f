// How well the robots stand up and kick, for each type: build/bench/motion.json. Physics of the league in
// this process; starts and ball places are random, the same in every run.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <string>

#include "../../motion/StandUpTrial.h"
#include "simspark/LeagueRobots.h"
#include "training/MotionTrial.h"

namespace {

using namespace plumbline;
using namespace plumbline::motion;
using namespace plumbline::training;

class Report {
public:
  void add(const std::string& name, double value, const std::string& unit, const std::string& better,
           const std::string& more = "") {
    char text[64];
    std::snprintf(text, sizeof text, "%.4g", value);
    lines_ += (lines_.empty() ? "[\n" : ",\n") + ("  {\"name\": \"motion." + name) +
              "\", \"value\": " + text + ", \"unit\": \"" + unit + "\", \"better\": \"" + better + "\"" +
              more + "}";
    std::printf("%-44s %8s %s\n", name.c_str(), text, unit.c_str());
    std::fflush(stdout);
  }
  void write(const std::filesystem::path& path) const {
    std::filesystem::create_directories(path.parent_path());
    const std::filesystem::path unfinished = path.string() + ".part";
    std::ofstream(unfinished) << lines_ << "\n]\n";
    std::filesystem::rename(unfinished, path);
  }

private:
  std::string lines_;
};

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[static_cast<std::size_t>(share * (values.size() - 1) + 0.5)];
}

std::string peer(const std::string& name, double value, double target) {
  char text[128];
  std::snprintf(text, sizeof text, ", \"target\": %g, \"peer\": \"%s\", \"peer_value\": %g", target,
                name.c_str(), value);
  return text;
}

struct StandUps {
  std::vector<double> seconds;                     ///< of those that got up
  std::map<LyingOn, std::vector<double>> byLying;  ///< the same, by how they lay at first
  int count = 0, first = 0, up = 0, walked = 0;
};

/// Falls with seeds from `first` on until there are `wanted`. directionOf: of a seed's fall.
template <typename Direction>
StandUps standUps(MotionTrial& trial, int wanted, Falls falls, unsigned first, const Direction& directionOf) {
  StandUps all;
  for (unsigned seed = first; all.count < wanted && seed - first < 10 * static_cast<unsigned>(wanted);
       ++seed) {
    const auto result = standUpTrial(trial, directionOf(seed), seed, falls);
    if (!result) continue;
    ++all.count;
    all.first += result->up && result->tries == 1;
    all.up += result->up;
    all.walked += result->walked;
    // Who did not get up counts with the whole time.
    all.byLying[result->lay].push_back(result->up ? result->seconds : longestStandUp);
    if (result->up) all.seconds.push_back(result->seconds);
  }
  return all;
}

double mean(const std::vector<double>& values) {
  return values.empty() ? 0 : std::accumulate(values.begin(), values.end(), 0.0) / values.size();
}

void standUp(Report& report, MotionTrial& trial, const std::string& type, int direction, int wanted) {
  const std::string side = direction > 0 ? "front" : direction < 0 ? "back" : "side";
  const std::string name = "stand_up_" + side + "_type" + type;
  const StandUps all = standUps(trial, wanted, Falls::dropped, 1, [&](unsigned) { return direction; });
  const double percent = 100.0 / all.count;
  // FC Portugal's times on the league's server: back 1.4 to 1.7 s, front 1.7 to 1.9 s.
  report.add(name + "_time_median", quantile(all.seconds, 0.5), "s", "lower",
             peer("FC Portugal",
                  direction > 0   ? 1.8
                  : direction < 0 ? 1.55
                                  : 2.35,
                  2.5));
  report.add(name + "_time_p95", quantile(all.seconds, 0.95), "s", "lower");
  report.add(name + "_first_try", all.first * percent, "%", "higher", ", \"target\": 95");
  report.add(name + "_up", all.up * percent, "%", "higher", ", \"target\": 100");
  report.add(name + "_walked_on", all.walked * percent, "%", "higher", ", \"target\": 95");
}

/// Robots that are pushed while they walk, to the front, back and sides in turn: from lying to standing.
void standUpInPlay(Report& report, MotionTrial& trial, const std::string& type, int wanted, unsigned first) {
  const std::string name = "stand_up_in_play_type" + type;
  StandUps all = standUps(trial, wanted, Falls::pushed, first,
                          [](unsigned seed) { return static_cast<int>(seed % 3) - 1; });
  all.seconds.resize(static_cast<std::size_t>(all.count), longestStandUp);  // of those that did not get up
  report.add(name + "_time_median", quantile(all.seconds, 0.5), "s", "lower", ", \"target\": 1");
  report.add(name + "_time_mean", mean(all.seconds), "s", "lower", ", \"target\": 1");
  report.add(name + "_time_p95", quantile(all.seconds, 0.95), "s", "lower");
  report.add(name + "_first_try", all.first * 100.0 / all.count, "%", "higher", ", \"target\": 95");
  for (const auto& [lay, side] :
       {std::pair{LyingOn::front, "front"}, {LyingOn::back, "back"}, {LyingOn::side, "side"}}) {
    report.add(name + "_time_mean_" + side, mean(all.byLying[lay]), "s", "lower");
    report.add(name + "_share_" + side, all.byLying[lay].size() * 100.0 / all.count, "%", "");
  }
}

/// motion: with the right foot, as all of motions/; the quick one has no word of its own in the figures.
void kick(Report& report, MotionTrial& trial, const std::string& motion, const std::string& type, Side foot,
          int count, double peerValue) {
  const std::string kind = motion == "kickRight" ? "" : motion + "_";
  const std::string name = "kick_" + kind + (foot == Side::left ? "left" : "right") + "_type" + type;
  std::vector<double> distances, angles;
  int falls = 0, good = 0;
  double seconds = 0;
  for (int i = 0; i < count; ++i) {
    const KickResult result = kickTrial(trial, foot, 0.02, static_cast<unsigned>(1000 + i), motion);
    distances.push_back(result.distance);
    angles.push_back(std::abs(result.angle) * 180 / pi);
    falls += result.fell;
    good += !result.fell && result.distance >= 2.5;
    seconds = std::max(seconds, result.seconds);
  }
  report.add(name + "_distance_median", quantile(distances, 0.5), "m", "higher",
             peer("FC Portugal Basic_Kick", peerValue, 2.5));
  report.add(name + "_distance_p5", quantile(distances, 0.05), "m", "higher");
  report.add(name + "_distance_max", quantile(distances, 1), "m", "higher");
  report.add(name + "_angle_p95", quantile(angles, 0.95), "deg", "lower");
  report.add(name + "_good", 100.0 * good / count, "%", "higher", ", \"target\": 95");
  report.add(name + "_falls", 100.0 * falls / count, "%", "lower", ", \"target\": 0");
  report.add(name + "_time", seconds, "s", "lower", ", \"target\": 1");
}

}  // namespace

/// COUNT of tries [60], five times as many in play; TYPE [-1: all, with a report]; with FIRST only those in
/// play, from that seed on.
int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 60;
  const int only = argc > 2 ? std::atoi(argv[2]) : -1;
  const int first = argc > 3 ? std::atoi(argv[3]) : 0;
  constexpr double kickPeers[] = {4.5, 5.1, 4.5, 4.5, 5.1};
  Report report;
  for (int type = 0; type < numSimsparkTypes(); ++type) {
    if (only >= 0 && type != only) continue;
    MotionTrial trial(type);
    const std::string name = std::to_string(type);
    if (first > 0) {
      standUpInPlay(report, trial, name, 5 * count, static_cast<unsigned>(first));
      continue;
    }
    standUp(report, trial, name, 1, count);
    standUp(report, trial, name, -1, count);
    standUp(report, trial, name, 0, count);
    standUpInPlay(report, trial, name, 5 * count, 1);
    for (const auto& motion : trial.motions)
      if (motion.kick)
        for (const Side foot : {Side::right, Side::left})
          kick(report, trial, motion.name, name, foot, count, kickPeers[type]);
  }
  if (only < 0 && first == 0) report.write("build/bench/motion.json");
  return 0;
}
