#include "walking/estimation/BackgroundFit.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace plumbline::walking {

BackgroundFit::BackgroundFit(const BackgroundFitOptions& options)
    : options_(options), thread_([this] { run(); }) {}

BackgroundFit::~BackgroundFit() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void BackgroundFit::add(const ObservedStep& step) {
  steps_.push_back(step);
  if (steps_.size() > options_.maxSteps) steps_.pop_front();
}

std::optional<ModelFitResult> BackgroundFit::pass(double dt, const ModelParameters& now,
                                                  const ModelParameters& prediction) {
  if (probation_) return judge(now, prediction);
  if (!running_) {
    if (steps_.size() < options_.steps) return std::nullopt;
    {
      const std::lock_guard lock(mutex_);
      work_.assign(steps_.begin(), steps_.end());
      start_ = now;
      startPrediction_ = prediction;
      seed_ = options_.fit.seed + fits_++;
      result_.reset();
    }
    changed_.notify_all();
    running_ = true;
    elapsed_ = 0;
  }
  elapsed_ += dt;
  if (elapsed_ < options_.duration) return std::nullopt;
  std::unique_lock lock(mutex_);
  if (options_.wait) changed_.wait(lock, [&] { return result_.has_value(); });
  if (!result_) return std::nullopt;
  running_ = false;
  // Steps walked with the old parameters show less about the new ones.
  steps_.clear();
  if (result_->hasNewParameters()) {
    probation_ = true;
    fallen_ = false;
    errorBefore_ = result_->leftOutBefore;
    predictionErrorBefore_ = result_->predictionLeftOutBefore;
    previous_ = now;
    previousPrediction_ = prediction;
  }
  return std::exchange(result_, std::nullopt);
}

std::optional<ModelFitResult> BackgroundFit::judge(const ModelParameters& now,
                                                   const ModelParameters& prediction) {
  if (!fallen_ && steps_.size() < options_.probation) return std::nullopt;
  probation_ = false;
  const std::vector<ObservedStep> walked(steps_.begin(), steps_.end());
  const double error = predictionError(walked, now), errorPredicting = predictionError(walked, prediction);
  const bool worse = now.values() != previous_.values() && error > errorBefore_,
             predictsWorse = prediction.values() != previousPrediction_.values() &&
                             errorPredicting > predictionErrorBefore_;
  if (!fallen_ && !worse && !predictsWorse) return std::nullopt;
  ModelFitResult back;
  back.parameters = fallen_ || worse ? previous_ : now;
  back.prediction = fallen_ || predictsWorse ? previousPrediction_ : prediction;
  back.accepted = back.predicts = back.rolledBack = true;
  back.leftOutBefore = error;
  back.leftOutAfter = errorBefore_;
  back.predictionLeftOutBefore = errorPredicting;
  back.predictionLeftOutAfter = predictionErrorBefore_;
  steps_.clear();
  return back;
}

void BackgroundFit::run() {
  if (options_.onThreadStart) options_.onThreadStart();
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return stop_ || !work_.empty(); });
    if (stop_) return;
    const std::vector<ObservedStep> mine = std::exchange(work_, {});
    const ModelParameters from = start_;
    ModelFitOptions fit = options_.fit;
    fit.seed = seed_;
    fit.prediction = startPrediction_;
    lock.unlock();
    // Pauses keep it within its share of time; they change when it ends, not its result.
    using Clock = std::chrono::steady_clock;
    auto begin = Clock::now();
    fit.keepGoing = [&] {
      const auto used = Clock::now() - begin;
      std::unique_lock pause(mutex_);
      if (!options_.wait && options_.cpuShare < 1)
        changed_.wait_for(pause, used * (1 / std::max(0.01, options_.cpuShare) - 1), [&] { return stop_; });
      begin = Clock::now();
      return !stop_;
    };
    ModelFitResult found = fitModel(mine, from, fit);
    lock.lock();
    result_ = std::move(found);
    changed_.notify_all();
  }
}

}  // namespace plumbline::walking
