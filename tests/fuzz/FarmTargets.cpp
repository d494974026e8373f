// The optimisation server: its messages, its journal, the study that it searches.
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "fuzz/Readers.h"
#include "optimization/farm/Journal.h"
#include "optimization/farm/Messages.h"
#include "training/Study.h"

namespace plumbline::fuzz {
namespace {

void farmMessage(std::string_view bytes) {
  refusesInOneLine([&] {
    const farm::Hello hello = farm::readHello(bytes);
    farm::readHello(farm::text(hello));
  });
  refusesInOneLine([&] {
    const farm::Answer answer = farm::readAnswer(bytes);
    require(farm::readAnswer(farm::text(answer)).number == answer.number, "an answer to another trial");
  });
  refusesInOneLine([&] {
    const farm::ToWorker message = farm::readToWorker(bytes);
    if (message.trial) farm::readToWorker(farm::text(*message.trial));
    if (message.welcome) farm::readToWorker(farm::text(*message.welcome));
  });
}

void farmJournal(std::string_view bytes) {
  const std::string path = scratchFile("evaluations.jsonl", bytes);
  std::int64_t read = 0;
  refusesInOneLine([&] {
    {
      farm::Journal journal(path, "mark", [&](const farm::JournalEntry&) { ++read; });
      require(journal.resumed() == read, "another number of results than were read");
      journal.add({}, {}, {}, "worker", 1);
    }
    const farm::Journal again(path, "mark", [](const farm::JournalEntry&) {});
    require(again.resumed() == read + 1, "a result is not read back");
  });
}

void studyFile(std::string_view bytes) {
  const std::string path = scratchFile("study.yaml", bytes);
  refusesInOneLine([&] {
    const training::Study study = training::readStudy(path);
    require(!study.parameters.empty(), "nothing is searched");
  });
}

std::vector<std::string> farmMessageSeeds() {
  farm::Answer answer{3, {1.5, -2, std::numeric_limits<double>::infinity()}, {{"speed", 0.5}}};
  farm::Welcome welcome{"standUp", {{"type", "0"}}, 7};
  Trial trial;
  trial.parameters = Eigen::VectorXd::LinSpaced(3, 1, 3);
  return {farm::text(farm::Hello{farm::Hello::Role::worker, "a-1", "secret"}),
          farm::text(answer),
          farm::text(welcome),
          farm::text(trial),
          R"({"over":"found"})",
          R"({"error":"no"})"};
}
std::vector<std::string> farmJournalSeeds() {
  const std::string begin = "{\"search\":\"mark\"}\n";
  return {begin, begin + R"({"trial":0,"generation":0,"costs":[1.5,null],"worker":"a","seconds":1})" + "\n",
          begin + "{\"trial\":1,\"costs\":null}\n{\"trial\":2,\"cos", ""};
}
std::vector<std::string> studyFileSeeds() {
  std::vector<std::string> all = contentsOf("config/optimisation", ".yaml");
  all.push_back(
      "task: sphere\noptions: {dimension: 3}\nparameters:\n  x0: {start: 1, step: 0.1, range: [-2, 2]}\n");
  return all;
}

const Registered farmMessageTarget({"farmMessage", farmMessage, farmMessageSeeds, 15000});
const Registered farmJournalTarget({"farmJournal", farmJournal, farmJournalSeeds, 1500});
const Registered studyFileTarget({"studyFile", studyFile, studyFileSeeds, 500});

}  // namespace
}  // namespace plumbline::fuzz
