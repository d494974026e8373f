#include "gap/diagnosis/EvidenceMark.h"

#include "gap/diagnosis/MarkDump.h"

namespace plumbline::gap {

namespace {

class EvidenceDump : public MarkDump {
public:
  using MarkDump::add;

  void add(const SignalNoise& noise) {
    const auto& [sigma, own, repeated] = noise;
    all(sigma, own, repeated);
  }
  void add(const Evidence& evidence) {
    add(evidence.trials());
    for (std::size_t t = 0; t < evidence.trials().size(); ++t)
      for (std::size_t s = 0; s < evidence.trials()[t].signals.size(); ++s)
        add(evidence.noise(t, s)), add(evidence.weights(t, s));
  }
  void add(const ReplayOptions& options) {
    // Of a replay each: joints, lostCycles, asSent.
    const auto& [joints, step, gearStep, settle, restarts, lostCycles, asSent, acrossCycles] = options;
    all(step, gearStep, settle, restarts, acrossCycles);
  }
  void add(const DiagnosisOptions& options) {
    // Without influence: jobs, memory, progress.
    const auto& [jobs, maxCauses, memory, progress] = options;
    add(maxCauses);
  }
};

}  // namespace

std::string markOf(const Evaluator& evaluator, const DiagnosisOptions& options) {
  EvidenceDump dump;
  dump.addProgram();
  dump.addLibrary();
  dump.add(evaluator.mechanism());
  dump.add(evaluator.evidence());
  dump.add(evaluator.replayOptions());
  dump.add(options);
  return dump.text();
}

}  // namespace plumbline::gap
