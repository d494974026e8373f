#include "gap/diagnosis/DiagnosisAttempts.h"

#include <optional>
#include <utility>

#include "framework/StopSignal.h"
#include "gap/diagnosis/CauseSearch.h"
#include "gap/diagnosis/EvidenceMark.h"
#include "gap/diagnosis/FineSteps.h"
#include "gap/diagnosis/RepeatNoise.h"

namespace plumbline::gap {

namespace {

constexpr const char* stageOfNoise = "what repeats differ by";

}  // namespace

struct DiagnosisAttempts::Attempt {
  Attempt(const Mechanism& robot, Evidence given, const std::string& file, const DiagnosisOptions& options,
          const Messages& messages)
      : evidence(std::move(given)),
        fine(robot, evidence, fineSteps(evidence, options.jobs)),
        memory(
            file, file.empty() ? "" : markOf(fine, options), robot, [&messages](const std::string& problem) {
              if (messages.problem)
                messages.problem(problem + "; a diagnosis that is stopped from now on repeats what follows");
            }) {}

  const Evidence evidence;
  Evaluator fine;
  SearchMemory memory;
};

DiagnosisAttempts::DiagnosisAttempts(const Mechanism& robot_, DiagnosisOptions options_,
                                     std::string memoryFile_, Messages messages_)
    : robot(robot_),
      options(std::move(options_)),
      memoryFile(std::move(memoryFile_)),
      messages(std::move(messages_)) {}

DiagnosisAttempts::~DiagnosisAttempts() = default;

Diagnosis DiagnosisAttempts::run(std::vector<Trial> trials) {
  const auto beginNoise = [this] {
    if (options.progress) options.progress(stageOfNoise, 0);
  };
  attempts.clear();
  try {
    beginNoise();
    Diagnosis first = attempt(evidenceOf(std::move(trials), options.jobs), memoryFile);
    if (first.findings.empty()) return first;
    beginNoise();
    std::optional<Evidence> besideLosses =
        evidenceBesideLosses(attempts.front()->evidence, first.explanation(), options.jobs);
    if (!besideLosses) return first;
    return attempt(*std::move(besideLosses), memoryFile.empty() ? "" : memoryFile + "2");
  } catch (const Stopped&) {
    for (auto last = attempts.rbegin(); last != attempts.rend(); ++last)
      if ((*last)->memory.size() > 0)
        throw Stopped("stopped; the same command goes on from " + (*last)->memory.file());
    throw;
  }
}

Diagnosis DiagnosisAttempts::attempt(Evidence evidence, const std::string& file) {
  Attempt& now =
      *attempts.emplace_back(std::make_unique<Attempt>(robot, std::move(evidence), file, options, messages));
  if (now.memory.size() > 0 && messages.resumed)
    messages.resumed("goes on from " + now.memory.file() + " (" + std::to_string(now.memory.size()) +
                     " searches done)");
  DiagnosisOptions withMemory = options;
  withMemory.memory = &now.memory;
  Evaluator coarse(now.fine.mechanism(), now.evidence, coarseSteps());
  return diagnose(now.fine, coarse, withMemory);
}

Evaluator& DiagnosisAttempts::evaluator() { return attempts.back()->fine; }

void DiagnosisAttempts::forget() {
  for (const auto& attempt : attempts) attempt->memory.forget();
}

}  // namespace plumbline::gap
