#pragma once
#include <memory>
#include <string>
#include <vector>

#include "motion/MotionParameters.h"
#include "training/SearchTask.h"
#include "training/tasks/TrialWorlds.h"

namespace plumbline::training {

/// Options of the task dive.
struct DiveOptions {
  PARAMETERS(DiveOptions)
  PARAMETER(std::string, motion, "diveLeft", "", Range(), "dive to begin with")
  PARAMETER(double, reaction, 0.16, "s", Range(0, 2), "time from the shot until the motion begins")
  PARAMETER(double, from, 0.2, "m", Range(-1, 2), "nearest that the ball crosses to the robot's left")
  PARAMETER(double, to, 0.9, "m", Range(-1, 2), "farthest that the ball crosses to the robot's left")
  PARAMETER_GROUP(WorldOptions, world, "robot and worlds")
};

/// A goalie's dive to the left. In a run the robot stands before its goal; a ball is shot at the line
/// that it stands on, so far to the left that a standing robot hardly stops it. The robot sees the shot after
/// `reaction` seconds and plays the motion. The cost is 1 for a goal and 0 for a save, less a tenth of the
/// share of the way to the ball's crossing that the body covers when the ball crosses. So a motion that saves
/// nothing yet has a direction to go.
///
/// Figures: saved (1 or 0), cover (the part of the way that is covered) [m].
class DiveTask : public SearchTask {
public:
  using Options = DiveOptions;
  explicit DiveTask(const DiveOptions& options);

  const std::vector<TaskParameter>& parameters() const override { return parameters_->list(); }
  TaskOutcome run(const Eigen::VectorXd& parameters, std::uint64_t seed) override;
  std::string file(const Eigen::VectorXd& parameters, const std::string& heading,
                   const std::map<std::string, double>& figures) const override;

private:
  TrialWorlds worlds_;
  double reaction_, from_, to_;
  std::unique_ptr<motion::MotionParameters> parameters_;
};

}  // namespace plumbline::training
