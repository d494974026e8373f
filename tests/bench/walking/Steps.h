#pragma once
#include <fmt/format.h>

#include <array>
#include <functional>
#include <optional>

#include "bench/walking/Sections.h"
#include "training/Walker.h"
#include "walking/estimation/BackgroundFit.h"

namespace plumbline::bench {

/// What tables 4.3 to 4.5 tell of steps, in mm and mm/s; y to the outside of the supporting foot.
struct StepFigures {
  Vec2 position = Vec2::Zero(), velocity = Vec2::Zero();  ///< predicted at the step's end minus observed
  Vec2 change = Vec2::Zero();                             ///< of the target within the step
  Vec2 footMean = Vec2::Zero();  ///< supporting foot at the step's end minus the reference's
  double footAbs = 0;
  int steps = 0;
};

struct Observed {
  StepFigures figures;
  int falls = 0;
  std::vector<Vec2> feet[2];  ///< supporting foot at the end of each step (figure 4.18)
  std::vector<Vec2> referenceFeet;
};

/// Follows a robot from step to step.
class StepWatch {
public:
  explicit StepWatch(training::Walker& robot) : robot_(robot) {}

  void cycle();
  /// The means.
  Observed finish();

private:
  void add(const walking::ObservedStep& step);

  training::Walker& robot_;
  Observed result_;
  walking::Support support_ = walking::Support::both;
  std::optional<Pose2> planned_;
  Pose2 last_;
};

/// The cells of position, velocity and change of the target.
std::vector<std::string> cellsOf(const StepFigures& f);
void append(std::vector<std::string>& cells, const std::vector<std::string>& more);

using Requests = std::function<walking::WalkRequest(double)>;

/// The walk as it is; with the fitted prediction; planned with what was fitted as well.
enum class Fit { none, prediction, plan };
inline constexpr std::array fits{Fit::none, Fit::prediction, Fit::plan};
const char* nameOf(Fit fit);

/// What models that were fitted to a robot give it: one while it walked as ever, one while it walked as that
/// planned.
struct FittedWalk {
  walking::ModelParameters prediction, plan, predictionOfPlan;

  void give(walking::WalkEngine& engine, Fit fit) const;
};

/// Walks as asked while the model is fitted to it, twice 20 s; the parameters that came of it. errors: the
/// least error after each generation of the first fit; steps: some that it was fitted to.
FittedWalk optimise(training::Walker& robot, const Requests& requests, std::vector<double>* errors = nullptr,
                    std::vector<walking::ObservedStep>* steps = nullptr);

/// 0.15 m/s forward and backward, changed every 3 s.
walking::WalkRequest forwardBackward(double time);

/// Table 4.5.
void tableAcceleration(const std::vector<Subject>& subjects, const BenchSetup& setup, Report& report,
                       Page& page);
/// Figures 4.13 and 4.14.
void figuresOfFit(const Subject& subject, Page& page);

}  // namespace plumbline::bench
