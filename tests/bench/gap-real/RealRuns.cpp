#include "RealRuns.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>

#include "gap/diagnosis/CauseSearch.h"
#include "gap/inference/Inference.h"
#include "gap/inference/SettingMask.h"
#include "gap/replay/Segments.h"
#include "gap/replay/TrialOf.h"
#include "gap/run/RunCheck.h"
#include "robot/MechanismFile.h"

namespace plumbline::bench {

namespace {

using namespace gap;

constexpr double startSeconds = 0.3;  // what came before a recording still rings

double processorSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Prints each stage once, with the seconds of the processor so far.
auto stagePrinter() {
  return [last = std::string(), begin = processorSeconds()](const std::string& stage, double) mutable {
    if (stage == last) return;
    last = stage;
    std::printf("  %6.0f s  %s\n", processorSeconds() - begin, stage.c_str());
    std::fflush(stdout);
  };
}

void diagnoseByBlocks(const Mechanism& robot, std::vector<Trial> fit, std::size_t maxCauses, int jobs,
                      RealResult& result) {
  const Evidence evidence(std::move(fit));
  Evaluator fine(robot, evidence);
  Evaluator coarse(robot, evidence, coarseSteps());
  DiagnosisOptions options;
  options.jobs = jobs;
  options.maxCauses = maxCauses;
  options.progress = stagePrinter();
  result.diagnosis = diagnose(fine, coarse, options);
}

void diagnoseBySets(const Mechanism& robot, const std::vector<Trial>& fit, int jobs, RealResult& result) {
  InferenceOptions options;
  options.jobs = jobs;
  options.progress = stagePrinter();
  const Inference inference = infer(robot, fit, options);
  result.diagnosis = inference.diagnosis;
  result.claim = inference.claim;
}

Trial trialAt(const std::string& folder, const Mechanism& robot) {
  std::vector<RunWarning> warnings;
  const Run run = readCheckedRun(folder, robot, warnings);
  for (const RunWarning& warning : warnings) std::printf("%s\n", warning.line(folder).c_str());
  return trialOf(run, robot);
}

double rmsOf(const Trial& trial, const Prediction& prediction) {
  double sum = 0, n = 0;
  for (std::size_t s = 0; s < trial.signals.size(); ++s) {
    const auto& predicted = prediction.values[s];
    if (trial.signals[s].kind != SignalKind::position || predicted.empty()) continue;
    for (std::size_t k = 0; k < trial.cycles(); ++k) {
      const double r = trial.signals[s].values[k] - predicted[k];
      if (!std::isfinite(r) || trial.time[k] - trial.time[0] < startSeconds) continue;
      sum += r * r;
      ++n;
    }
  }
  return n > 0 ? std::sqrt(sum / n) : 0;
}

/// Lag of what was measured behind its command, which two sessions may share although their clocks do not.
std::vector<double> lagOf(const Trial& trial, const Signal& signal) {
  std::vector<double> lag = signal.values;
  const auto& command = trial.command[static_cast<std::size_t>(signal.joint)];
  for (std::size_t k = 0; k < lag.size(); ++k) lag[k] = command.empty() ? NAN : lag[k] - command[k];
  return lag;
}

double between(const Trial& trial, const std::vector<double>& values, double time) {
  const auto& t = trial.time;
  const auto next = std::lower_bound(t.begin(), t.end(), time);
  if (next == t.begin() || next == t.end()) return NAN;
  const auto k = static_cast<std::size_t>(next - t.begin());
  const double share = (time - t[k - 1]) / (t[k] - t[k - 1]);
  return values[k - 1] + share * (values[k] - values[k - 1]);
}

/// One recording's own part of the difference between two.
double repeatFloor(const Trial& a, const Trial& b) {
  double sum = 0, n = 0;
  for (const Signal& first : a.signals)
    for (const Signal& second : b.signals) {
      if (first.kind != SignalKind::position || first.name != second.name) continue;
      const std::vector<double> own = lagOf(a, first), other = lagOf(b, second);
      for (std::size_t k = 0; k < a.cycles(); ++k) {
        const double elapsed = a.time[k] - a.time[0];
        const double d = own[k] - between(b, other, b.time[0] + elapsed);
        if (!std::isfinite(d) || elapsed < startSeconds) continue;
        sum += d * d;
        ++n;
      }
    }
  return n > 0 ? std::sqrt(sum / n / 2) : 0;
}

/// What is expected in the tests: which settings they were made with is not known.
Explanation elsewhere(const RealSplit& split, const std::string& folder, const Diagnosis& diagnosis) {
  std::vector<std::string> recordings;
  for (const std::string& run : split.fit) recordings.push_back(folder + "/" + run);
  return expectedElsewhere(diagnosis.replayed(), recordings);
}

}  // namespace

const char* nameOf(Method method) { return method == Method::sets ? "sets" : "blocks"; }

RealResult runSplit(const RealSplit& split, const std::string& robotName, const std::string& folder,
                    std::size_t maxCauses, int jobs, Method method) {
  const Mechanism robot = findMechanism(robotName);
  std::vector<Trial> fit, test;
  for (const std::string& run : split.fit)
    for (Trial& part : segmentsOf(trialAt(folder + "/" + run, robot), split.fitSeconds))
      fit.push_back(std::move(part));
  for (const std::string& run : split.test) test.push_back(trialAt(folder + "/" + run, robot));

  RealResult result;
  const double begin = processorSeconds();
  if (method == Method::sets)
    diagnoseBySets(robot, fit, jobs, result);
  else
    diagnoseByBlocks(robot, std::move(fit), maxCauses, jobs, result);
  result.seconds = processorSeconds() - begin;

  const Evidence tests(test);
  Evaluator judge(robot, tests);
  const auto predictionsWith = [&](const Explanation& causes) {
    judge.setBase(causes);
    std::vector<Prediction> predictions;
    for (std::size_t t = 0; t < test.size(); ++t) predictions.push_back(judge.basePrediction(t));
    return predictions;
  };
  const std::vector<Prediction> nominal = predictionsWith({}),
                                corrected = predictionsWith(elsewhere(split, folder, result.diagnosis));
  double before = 0, after = 0, floor = 0, n = 0;
  for (std::size_t t = 0; t < test.size(); ++t) {
    TestError error{split.test[t], rmsOf(test[t], nominal[t]), rmsOf(test[t], corrected[t]), 0, false};
    if (const auto it = split.repeats.find(split.test[t]); it != split.repeats.end()) {
      error.repeated = true;
      error.floor = repeatFloor(test[t], trialAt(folder + "/" + it->second, robot));
    }
    if (split.repeats.empty() || error.repeated) {
      before += error.before * error.before;
      after += error.after * error.after;
      floor += error.floor * error.floor;
      ++n;
    }
    result.tests.push_back(error);
  }
  result.before = std::sqrt(before / n);
  result.after = std::sqrt(after / n);
  result.floor = std::sqrt(floor / n);
  return result;
}

}  // namespace plumbline::bench
