// What long work leaves for its next start: a diagnosis and a search for a walk.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "fuzz/Readers.h"
#include "gap/diagnosis/SearchMemory.h"
#include "gap/effects/Effects.h"
#include "gap/inference/InferenceMemory.h"
#include "robot/MechanismFile.h"
#include "training/WalkCheckpoint.h"

namespace plumbline::fuzz {
namespace {

/// The bytes as a whole file, or where they are JSON as the content of a file whose mark and sum are right:
/// no bytes that are drawn would have those.
std::string memoryOf(std::string_view bytes, const char* name) {
  std::string path = scratchFile(name, bytes);
  const nlohmann::json content = nlohmann::json::parse(bytes, nullptr, false);
  if (!content.is_discarded() && !(content.is_object() && content.contains("mark")))
    gap::MemoryFile(path, "mark", {}).write(content);
  return path;
}

void searchMemory(std::string_view bytes) {
  static const Mechanism robot = findMechanism("xl330_pendulum");
  refusesInOneLine([&] {
    const std::string path = memoryOf(bytes, "answer.searches");
    gap::SearchMemory memory(path, "mark", robot, expectOneLine);
    const std::size_t had = memory.size();
    memory.keep({}, {});
    require(gap::SearchMemory(path, "mark", robot).size() == had + 1, "a search is not remembered");
  });
}

void inferenceMemory(std::string_view bytes) {
  static const Mechanism robot = findMechanism("xl330_pendulum");
  refusesInOneLine([&] {
    const std::string path = memoryOf(bytes, "sets.searches");
    gap::InferenceMemory memory(path, "mark", robot, expectOneLine);
    const std::size_t had = memory.size();
    memory.keep("one more fit", gap::StoredValues{});
    const std::string first = contentOf(path);
    gap::InferenceMemory again(path, "mark", robot);
    require(again.size() == memory.size() && again.size() >= had, "what was read is not remembered");
    again.keep("one more fit", gap::StoredValues{});
    require(contentOf(path) == first, "what was read changes when it is written again");
  });
}

void walkCheckpoint(std::string_view bytes) {
  const std::string path = scratchFile("walking.yaml.search", bytes);
  refusesInOneLine([&] {
    const training::WalkCheckpoint checkpoint(path, "mark");
    require(checkpoint.resumed(), "a file that is there was not read");
  });
  refusesInOneLine([&] {
    const walking::WalkGaits gaits = training::walkOfExactText(std::string(bytes));
    require(training::exactText(training::walkOfExactText(training::exactText(gaits))) ==
                training::exactText(gaits),
            "a walk changes when it is read back");
  });
}

/// The file at a path, and what it holds.
std::vector<std::string> fileAndContent(const std::string& path) {
  nlohmann::json content;
  gap::MemoryFile(path, "mark", {}).read([&](const nlohmann::json& stored) { content = stored; });
  return {contentOf(path), content.dump()};
}

std::vector<std::string> inferenceMemorySeeds() {
  const Mechanism robot = findMechanism("xl330_pendulum");
  const std::string path = scratchFolder() + "/seed.sets";
  std::filesystem::remove(path);
  gap::InferenceMemory memory(path, "mark", robot);
  const gap::Effect* effect = gap::findEffect("backlash");
  const gap::Cause cause{effect, gap::findPlace(*effect, robot, "pendulum", ""), 0.03, 0, {}};
  gap::Scored one, none;
  one.fitted.causes = {cause};
  one.without = {{cause}, {cause}};
  none.without = {{}, {}};
  one.gain = none.gain = {1.5, 0.25};
  memory.keep("sets of causes", gap::StoredSearch{{{one, none}, {none}, 9}, 40});
  memory.keep("values", gap::StoredValues{{cause}, 3});
  return fileAndContent(path);
}

std::vector<std::string> searchMemorySeeds() {
  const Mechanism robot = findMechanism("xl330_pendulum");
  const std::string path = scratchFolder() + "/seed.searches";
  std::filesystem::remove(path);
  gap::SearchMemory memory(path, "mark", robot);
  const gap::Effect* effect = gap::findEffect("backlash");
  gap::SearchStart start;
  gap::SearchResult result;
  gap::FittedCause candidate;
  candidate.cause = {effect, gap::findPlace(*effect, robot, "pendulum", ""), 0.03, 0, {}};
  result.candidates = {candidate};
  result.lostCycles = {{1, 0, 1}};
  memory.keep(start, result);
  start.base.push_back(candidate.cause);
  memory.keep(start, result);
  std::vector<std::string> seeds = fileAndContent(path);
  seeds.emplace_back(R"({"mark":"other","content":[],"sum":""})");
  return seeds;
}

std::vector<std::string> walkCheckpointSeeds() {
  const std::string walk = training::exactText({});
  const std::string line = walk.substr(0, walk.find('\n')) + "\\n";
  return {R"({"mark":"mark","done":[],"search":"00ff"})", R"({"mark":"other","done":[],"search":""})",
          R"({"mark":"mark","done":[")" + line + R"("],"search":""})", walk};
}

const Registered inferenceMemoryTarget({"inferenceMemory", inferenceMemory, inferenceMemorySeeds, 3000});
const Registered searchMemoryTarget({"searchMemory", searchMemory, searchMemorySeeds, 3000});
const Registered walkCheckpointTarget({"walkCheckpoint", walkCheckpoint, walkCheckpointSeeds, 4000});

}  // namespace
}  // namespace plumbline::fuzz
