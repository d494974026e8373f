// What long work leaves for its next start: a diagnosis and a search for a walk.
#include <filesystem>

#include "fuzz/Readers.h"
#include "gap/diagnosis/SearchMemory.h"
#include "gap/effects/Effects.h"
#include "robot/MechanismFile.h"
#include "training/WalkCheckpoint.h"

namespace plumbline::fuzz {
namespace {

void searchMemory(std::string_view bytes) {
  static const Mechanism robot = findMechanism("xl330_pendulum");
  const std::string path = scratchFile("answer.searches", bytes);
  refusesInOneLine([&] {
    gap::SearchMemory memory(path, "mark", robot);
    const std::size_t had = memory.size();
    memory.keep({}, {});
    require(gap::SearchMemory(path, "mark", robot).size() == had + 1, "a search is not remembered");
  });
}

void walkCheckpoint(std::string_view bytes) {
  const std::string path = scratchFile("walking.yaml.search", bytes);
  refusesInOneLine([&] {
    const walking::WalkCheckpoint checkpoint(path, "mark");
    require(checkpoint.resumed(), "a file that is there was not read");
  });
  refusesInOneLine([&] {
    const walking::WalkGaits gaits = walking::walkOfExactText(std::string(bytes));
    require(
        walking::exactText(walking::walkOfExactText(walking::exactText(gaits))) == walking::exactText(gaits),
        "a walk changes when it is read back");
  });
}

std::vector<std::string> searchMemorySeeds() {
  const Mechanism robot = findMechanism("xl330_pendulum");
  const std::string path = scratchFolder() + "/seed.searches";
  std::filesystem::remove(path);
  gap::SearchMemory memory(path, "mark", robot);
  const gap::Effect* effect = gap::findEffect("backlash");
  gap::SearchStart start;
  gap::SearchResult result;
  gap::Candidate candidate;
  candidate.cause = {effect, gap::findPlace(*effect, robot, "pendulum", ""), 0.03, 0, {}};
  result.candidates = {candidate};
  result.lostCycles = {{1, 0, 1}};
  memory.keep(start, result);
  start.base.push_back(candidate.cause);
  memory.keep(start, result);
  return {contentOf(path), R"({"mark":"other","searches":[]})", R"({"mark":"mark","searches":[]})"};
}

std::vector<std::string> walkCheckpointSeeds() {
  const std::string walk = walking::exactText({});
  const std::string line = walk.substr(0, walk.find('\n')) + "\\n";
  return {R"({"mark":"mark","done":[],"search":"00ff"})", R"({"mark":"other","done":[],"search":""})",
          R"({"mark":"mark","done":[")" + line + R"("],"search":""})", walk};
}

const Registered searchMemoryTarget({"searchMemory", searchMemory, searchMemorySeeds, 3000});
const Registered walkCheckpointTarget({"walkCheckpoint", walkCheckpoint, walkCheckpointSeeds, 4000});

}  // namespace
}  // namespace plumbline::fuzz
