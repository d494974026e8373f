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
        memory(file, file.empty() ? "" : markOf(fine, options), robot, messages.problem) {}

  const Evidence evidence;
  Evaluator fine;
  SearchMemory memory;
};

DiagnosisAttempts::DiagnosisAttempts(const Mechanism& robot, DiagnosisOptions options, std::string memoryFile,
                                     Messages messages)
    : robot_(robot),
      options_(std::move(options)),
      memoryFile_(std::move(memoryFile)),
      messages_(std::move(messages)) {}

DiagnosisAttempts::~DiagnosisAttempts() = default;

Diagnosis DiagnosisAttempts::run(std::vector<Trial> trials) {
  const auto beginNoise = [this] {
    if (options_.progress) options_.progress(stageOfNoise, 0);
  };
  attempts_.clear();
  try {
    beginNoise();
    Diagnosis first = attempt(evidenceOf(std::move(trials), options_.jobs), memoryFile_);
    if (first.findings.empty()) return first;
    beginNoise();
    std::optional<Evidence> withoutLosses =
        evidenceWithoutLosses(attempts_.front()->evidence, first.explanation(), options_.jobs);
    if (!withoutLosses) return first;
    return attempt(*std::move(withoutLosses), memoryFile_.empty() ? "" : memoryFile_ + "2");
  } catch (const Stopped&) {
    for (auto last = attempts_.rbegin(); last != attempts_.rend(); ++last)
      if ((*last)->memory.size() > 0)
        throw Stopped("stopped; the same command continues from " + (*last)->memory.file());
    throw;
  }
}

Diagnosis DiagnosisAttempts::attempt(Evidence evidence, const std::string& file) {
  Attempt& now = *attempts_.emplace_back(
      std::make_unique<Attempt>(robot_, std::move(evidence), file, options_, messages_));
  if (now.memory.size() > 0 && messages_.resumed)
    messages_.resumed("continues from " + now.memory.file() + " (" + std::to_string(now.memory.size()) +
                      " searches done)");
  DiagnosisOptions withMemory = options_;
  withMemory.memory = &now.memory;
  Evaluator coarse(now.fine.mechanism(), now.evidence, coarseSteps());
  return diagnose(now.fine, coarse, withMemory);
}

Evaluator& DiagnosisAttempts::evaluator() { return attempts_.back()->fine; }

void DiagnosisAttempts::forget() {
  for (const auto& attempt : attempts_) attempt->memory.forget();
}

}  // namespace plumbline::gap
