#pragma once
#include <memory>
#include <string>
#include <vector>

#include "motion/MotionParameters.h"
#include "training/SearchTask.h"
#include "training/tasks/TrialWorlds.h"

namespace plumbline::training {

/// A goalie's dive to the left. In a run the robot stands before its goal; a ball is shot at the line
/// that it stands on, so far to the left that a standing robot hardly stops it. The robot sees the shot after
/// `reaction` seconds and plays the motion. The cost is 1 for a goal and 0 for a save, less a tenth of the
/// share of the way to the ball's crossing that the body covers when the ball crosses. So a motion that saves
/// nothing yet has a direction to go.
///
/// Figures: saved (1 or 0), cover (the part of the way that is covered) [m].
/// Options: type (0), motion (diveLeft), reaction (0.16) [s], from and to (0.2, 0.9): the ball's distance to
/// the robot's left when it crosses [m], and those of TrialWorlds.
class DiveTask : public SearchTask {
public:
  explicit DiveTask(const TaskOptions& options);

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
