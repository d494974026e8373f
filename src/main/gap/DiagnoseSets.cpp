#include "main/gap/DiagnoseSets.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "framework/StopSignal.h"
#include "framework/WriteFile.h"
#include "gap/answer/SetsAnswer.h"
#include "gap/inference/InferenceMark.h"
#include "gap/inference/InferenceMemory.h"
#include "gap/inference/JointValues.h"
#include "gap/inference/LeftJson.h"
#include "gap/report/MotionQuestion.h"
#include "main/gap/ProgressLine.h"

namespace plumbline::gap {

namespace {

void print(const Inference& inference, const AllJointFit& further, const AnswerInput& input) {
  std::printf("%s\n", inference.sentence().c_str());
  if (const std::string more = further.sentence(); !more.empty()) std::printf("%s\n", more.c_str());
  for (const Finding& finding : inference.diagnosis.findings) {
    std::printf("  %-48s %5.1f %%  [%.3g, %.3g]  evidence %.0f, closes %.0f %% alone, %.0f %% last\n",
                describe(finding.cause).c_str(), 100 * finding.probability, finding.lower, finding.upper,
                *finding.evidence, 100 * finding.closedAlone, 100 * finding.closedLast);
    for (const Rival& rival : finding.rivals)
      std::printf("    or %-45s %5.1f %%\n", describe(rival.cause).c_str(), 100 * rival.probability);
  }
  std::printf("%s", jointValuesText(inference.diagnosis.jointValues).c_str());
  for (const std::string& line : inference.onlyIn) std::printf("  %s\n", line.c_str());
  if (inference.diagnosis.verdict != Verdict::none)
    std::printf("Left out of search and fit, each in turn:\n%s", leftTable(inference.leftOut).c_str());
  for (const std::string& line : inference.notUsed) std::printf("%s\n", line.c_str());
  if (const std::string line = inference.runToRun(); !line.empty()) std::printf("%s\n", line.c_str());
  std::printf("Next: %s\n", input.nextMotion.c_str());
}

}  // namespace

void diagnoseBySets(const SetsRequest& request, std::vector<Trial> trials, AnswerInput input,
                    const Timing& timing) {
  InferenceOptions options;
  options.jobs = request.jobs;
  if (request.maxCauses > 0) options.mostCauses = static_cast<std::size_t>(request.maxCauses);
  Inference inference;
  AllJointFit further;
  std::optional<InferenceMemory> memory;
  try {
    ProgressLine line(request.quiet);
    if (!request.memory.empty()) {
      memory.emplace(request.memory, markOf(request.robot, trials, options), request.robot,
                     [&line](const std::string& problem) { line.say(problem); });
      options.memory = &*memory;
      if (memory->size() > 0 && !request.quiet)
        line.say("continues from " + memory->file() + " (" + memory->sizeText() + ")");
    }
    options.progress = [&line](const std::string& stage, double share) { line.update(stage, share); };
    line.update("noise of the readings", 0);
    inference = infer(request.robot, trials, options);
    // If the named causes explain everything, nothing is left for the fit of all joints.
    if (inference.diagnosis.verdict == Verdict::unknown) {
      further = fitOfAllJoints(request.robot, trials, inference.diagnosis.explanation(),
                               inference.foundWithout, inference.leftOut, options);
    }
  } catch (const Stopped&) {
    if (memory && memory->size() > 0)
      throw Stopped("stopped; the same command continues from " + memory->file());
    throw;
  }
  const Evidence evidence(std::move(trials), inference.noises);
  input.nextMotion = separatingMotion(request.robot, inference.diagnosis);
  if (input.nextMotion.empty()) input.nextMotion = suggestion(inference.diagnosis, evidence);
  const std::string text = setsAnswer(inference, further, input, evidence, request.robot).dump(1) + "\n";
  timing.write(request.timing);
  if (request.json == "-") {
    std::fputs(text.c_str(), stdout);
    return;
  }
  if (!request.json.empty()) writeFile(request.json, text);
  if (memory) memory->forget();
  print(inference, further, input);
}

}  // namespace plumbline::gap
