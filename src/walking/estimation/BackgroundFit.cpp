#include "walking/estimation/BackgroundFit.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace plumbline::walking {

BackgroundFit::BackgroundFit(const BackgroundFitOptions& options_)
    : options(options_), thread([this] { run(); }) {}

BackgroundFit::~BackgroundFit() {
  {
    const std::lock_guard lock(mutex);
    stop = true;
  }
  changed.notify_all();
  thread.join();
}

void BackgroundFit::add(const ObservedStep& step) {
  steps.push_back(step);
  if (steps.size() > options.maxSteps) steps.pop_front();
}

std::optional<ModelFitResult> BackgroundFit::pass(double dt, const ModelParameters& now,
                                                  const ModelParameters& prediction) {
  if (probation) return judge(now, prediction);
  if (!running) {
    if (steps.size() < options.steps) return std::nullopt;
    {
      const std::lock_guard lock(mutex);
      work.assign(steps.begin(), steps.end());
      start = now;
      startPrediction = prediction;
      seed = options.fit.seed + fits++;
      result.reset();
    }
    changed.notify_all();
    running = true;
    elapsed = 0;
  }
  elapsed += dt;
  if (elapsed < options.duration) return std::nullopt;
  std::unique_lock lock(mutex);
  if (options.wait) changed.wait(lock, [&] { return result.has_value(); });
  if (!result) return std::nullopt;
  running = false;
  // Steps walked with the old parameters tell less of the new ones.
  steps.clear();
  if (result->anyNew()) {
    probation = true;
    fallen = false;
    errorBefore = result->heldBefore;
    predictionErrorBefore = result->predictionHeldBefore;
    previous = now;
    previousPrediction = prediction;
  }
  return std::exchange(result, std::nullopt);
}

std::optional<ModelFitResult> BackgroundFit::judge(const ModelParameters& now,
                                                   const ModelParameters& prediction) {
  if (!fallen && steps.size() < options.probation) return std::nullopt;
  probation = false;
  const std::vector<ObservedStep> walked(steps.begin(), steps.end());
  const double error = predictionError(walked, now), errorPredicting = predictionError(walked, prediction);
  const bool worse = now.values() != previous.values() && error > errorBefore,
             predictsWorse = prediction.values() != previousPrediction.values() &&
                             errorPredicting > predictionErrorBefore;
  if (!fallen && !worse && !predictsWorse) return std::nullopt;
  ModelFitResult back;
  back.parameters = fallen || worse ? previous : now;
  back.prediction = fallen || predictsWorse ? previousPrediction : prediction;
  back.accepted = back.predicts = back.rolledBack = true;
  back.heldBefore = error;
  back.heldAfter = errorBefore;
  back.predictionHeldBefore = errorPredicting;
  back.predictionHeldAfter = predictionErrorBefore;
  steps.clear();
  return back;
}

void BackgroundFit::run() {
  if (options.onThreadStart) options.onThreadStart();
  std::unique_lock lock(mutex);
  for (;;) {
    changed.wait(lock, [&] { return stop || !work.empty(); });
    if (stop) return;
    const std::vector<ObservedStep> mine = std::exchange(work, {});
    const ModelParameters from = start;
    ModelFitOptions fit = options.fit;
    fit.seed = seed;
    fit.prediction = startPrediction;
    lock.unlock();
    // Pauses keep it within its share; they change when it is done, not what it finds.
    using Clock = std::chrono::steady_clock;
    auto begin = Clock::now();
    fit.goOn = [&] {
      const auto used = Clock::now() - begin;
      std::unique_lock pause(mutex);
      if (!options.wait && options.cpuShare < 1)
        changed.wait_for(pause, used * (1 / std::max(0.01, options.cpuShare) - 1), [&] { return stop; });
      begin = Clock::now();
      return !stop;
    };
    ModelFitResult found = fitModel(mine, from, fit);
    lock.lock();
    result = std::move(found);
    changed.notify_all();
  }
}

}  // namespace plumbline::walking
