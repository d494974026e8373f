#pragma once
#include <memory>
#include <string>
#include <vector>

#include "framework/ConfigFile.h"
#include "tactics/approach/WalkToPlace.h"
#include "training/MotionTrial.h"
#include "training/SearchTask.h"
#include "training/SearchedGroup.h"

namespace plumbline::training {

/// Options of the task moveToPos.
struct MoveToPosOptions {
  PARAMETERS(MoveToPosOptions)
  PARAMETER(std::string, type, "all", "", Range(),
            "number of the league's type of robot, or all: each by turns")
  PARAMETER(double, nearest, 0.4, "m", Range(0.1, 10), "least distance of a start")
  PARAMETER(double, farthest, 10, "m", Range(0.1, 12), "largest distance of a start")
  PARAMETER(double, fall, 8, "s", Range(0, 100), "worth of a fall")
};

/// Walking to a place without the ball: the robot stands anywhere up to `farthest` from it, with any heading,
/// walks there and stops. Distances are drawn evenly in their logarithm. Searched are numbers of
/// WalkToPoseParameters; the file is SkillMoveToPos.yaml. The last metres are planned as its `plan` says.
///
/// The cost of a run is the time until the robot has been there for 0.3 s, within 8 cm and 0.2 rad, and
/// `fall` seconds for a fall.
class MoveToPosTask : public SearchTask {
public:
  using Options = MoveToPosOptions;
  explicit MoveToPosTask(const MoveToPosOptions& options);

  const std::vector<TaskParameter>& parameters() const override { return searched_.parameters(); }
  TaskOutcome run(const Eigen::VectorXd& parameters, std::uint64_t seed) override;
  std::string file(const Eigen::VectorXd& parameters, const std::string& heading,
                   const std::map<std::string, double>& figures) const override;

private:
  MoveToPosTask(const MoveToPosOptions& options, const ConfigFile& file);

  double nearest_, farthest_, fall_;  ///< options [m, m, s]
  SearchedGroup<WalkToPoseParameters> searched_;
  ApproachPlannerParameters plan_;
  std::vector<std::unique_ptr<MotionTrial>> robots_;  ///< one of each type
};

}  // namespace plumbline::training
