// What others do, on the recordings that peers.sh gives to bin/gap diagnose. That is everything at once per
// joint by Gauss-Newton and by CMA-ES, what MuJoCo's system identification and PACE fit, the friction models
// M1 to M6 of BAM, the best single effect. All are fitted to the recordings for fitting and measured as
// bin/gap check measures: free replays of the others. Environment: DATA, their folder; SPLIT, one of
// splits.txt alone; JOBS [1]. Pieces that are in build/gap-peers are taken as they are.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "PeerFits.h"
#include "framework/WriteFile.h"
#include "gap/inference/HoldOut.h"
#include "gap/replay/Segments.h"
#include "gap/replay/TrialOf.h"
#include "gap/run/RunCheck.h"
#include "gap/run/RunFile.h"
#include "robot/MechanismFile.h"
#include "support/Environment.h"

#include <nlohmann/json.hpp>

using namespace plumbline;
using namespace plumbline::gap;
using namespace plumbline::bench;
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr double segmentSeconds = 20;  // as peers.sh asks of bin/gap diagnose

struct PeerSplit {
  std::string name, robot;
  std::vector<std::string> fit, test;
};

std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::vector<PeerSplit> readSplits(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + " cannot be read");
  std::vector<PeerSplit> splits;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream stream(line);
    std::string name, robot, fit, test;
    if (!std::getline(stream, name, '|') || !std::getline(stream, robot, '|') ||
        !std::getline(stream, fit, '|') || !std::getline(stream, test))
      throw std::runtime_error(path + ": not four fields: " + line);
    splits.push_back({name, robot, wordsOf(fit), wordsOf(test)});
  }
  return splits;
}

std::vector<Trial> trialsIn(const std::string& folder, const std::vector<std::string>& motions,
                            const Mechanism& robot) {
  std::vector<Trial> trials;
  for (const std::string& motion : motions) {
    std::vector<RunWarning> warnings;
    trials.push_back(trialOf(readCheckedRun(folder + "/" + motion, robot, warnings, {}), robot));
  }
  return trials;
}

json pieceOf(const PeerSplit& split, const PeerFit& fit, const std::vector<Trial>& tests) {
  std::vector<RecordingLeft> left;
  json runs = json::array();
  for (const Trial& trial : tests) {
    left.push_back(leftIn(trial, {{0, fit.causes}}));
    runs.push_back({{"folder", left.back().folder}, {"closed", left.back().closed()}});
  }
  return {{"split", split.name},
          {"peer", fit.name},
          {"parameters", fit.parameters},
          {"closed", meanClosed(left)},
          {"fitted_closed", fit.closedFitting},
          {"runs", runs},
          {"cpu_seconds", fit.cpuSeconds},
          {"what", fit.what}};
}

}  // namespace

int main() try {
  const char* given = std::getenv("DATA");
  const std::string data = given && *given ? given : "../shared/gap/real", kept = "build/gap-peers";
  if (!fs::is_directory(data))
    throw std::runtime_error(data + " is not there: make bench-gap-peers DATA=FOLDER");
  const char* one = std::getenv("SPLIT");
  const auto jobs = static_cast<int>(std::clamp<std::uint64_t>(environment("JOBS", 1), 1, 256));
  fs::create_directories(kept);
  for (const PeerSplit& split : readSplits("tests/bench/gap-peers/splits.txt")) {
    if (one && *one && split.name != one) continue;
    const Mechanism robot = namedMechanism(split.robot);
    const std::string folder = data + "/" + split.robot;
    std::vector<Trial> segments;
    for (std::vector<Trial>& of : segmentsOf(trialsIn(folder, split.fit, robot), segmentSeconds))
      for (Trial& segment : of) segments.push_back(std::move(segment));
    const std::vector<Trial> tests = trialsIn(folder, split.test, robot);
    const Peers peers(robot, std::move(segments), jobs);
    for (const std::string& name : peers.names()) {
      const std::string piece = kept + "/" + split.name + ".peer-" + name + ".json";
      if (fs::exists(piece)) continue;
      const json result = pieceOf(split, peers.fit(name), tests);
      writeFile(piece, result.dump(1) + "\n");
      std::printf("%s, %s: closes %.0f %%\n", split.name.c_str(), name.c_str(),
                  100 * result["closed"].get<double>());
      std::fflush(stdout);
    }
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "bench gap-peers: %s\n", error.what());
  return 2;
}
