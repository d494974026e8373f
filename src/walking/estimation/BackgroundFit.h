#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "walking/estimation/ModelFit.h"

namespace plumbline::walking {

struct BackgroundFitOptions {
  std::size_t steps = 30;     ///< observed before a fit begins
  std::size_t maxSteps = 90;  ///< kept at most, the newest
  double duration = 20;       ///< walking time from a fit's beginning to the use of its result [s]
  double cpuShare = 0.2;      ///< of one core, at most
  /// Waits for a result that is due, so that a run depends on nothing but its input; else it comes late.
  bool wait = false;
  std::size_t probation = 20;  ///< steps by which a new set is judged before the next fit
  ModelFitOptions fit{};
  std::function<void()> onThreadStart{};  ///< gives the thread its low priority
};

/// Fits the model to the robot while it walks (section 4.3.2): collects steps, fits in a thread of its own,
/// returns the result when it is due, and begins again. A new set is tested: if it predicts its own steps
/// worse than the previous set predicted its steps, or the robot falls, the previous set returns. The same
/// holds for the set that only predicts.
class BackgroundFit {
public:
  explicit BackgroundFit(const BackgroundFitOptions& options);
  ~BackgroundFit();
  BackgroundFit(const BackgroundFit&) = delete;
  BackgroundFit& operator=(const BackgroundFit&) = delete;

  /// A step walked with these parameters.
  void add(const ObservedStep& step);
  /// Lets walking time pass [s]; now, prediction: the parameters in use. The result that has become due, if
  /// any; use its two sets from now on (they are those in use where nothing better was found).
  std::optional<ModelFitResult> pass(double dt, const ModelParameters& now,
                                     const ModelParameters& prediction = {});
  bool busy() const { return running_; }
  /// The robot fell while walking: a set on probation has failed.
  void fell() { fallen_ = true; }
  bool onProbation() const { return probation_; }

private:
  std::optional<ModelFitResult> judge(const ModelParameters& now, const ModelParameters& prediction);
  void run();

  const BackgroundFitOptions options_;
  std::deque<ObservedStep> steps_;
  double elapsed_ = 0;    ///< since the fit began [s]
  bool running_ = false;  ///< of the walking thread: a fit has begun and its result was not yet handed over
  std::uint64_t fits_ = 0;
  bool probation_ = false, fallen_ = false;
  /// Of the set before on steps walked with it; of the prediction before.
  double errorBefore_ = 0, predictionErrorBefore_ = 0;
  ModelParameters previous_, previousPrediction_;  ///< the sets before

  std::mutex mutex_;
  std::condition_variable changed_;
  bool stop_ = false;
  std::vector<ObservedStep> work_;  ///< what the thread is to fit
  ModelParameters start_, startPrediction_;
  std::uint64_t seed_ = 1;
  std::optional<ModelFitResult> result_;
  std::thread thread_;
};

}  // namespace plumbline::walking
