#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "training/SearchTask.h"
#include "training/WalkTraining.h"
#include "training/tasks/TrialWorlds.h"

namespace plumbline::training {

/// Options of the task walk.
struct WalkOptions {
  PARAMETERS(WalkOptions)
  PARAMETER(std::string, direction, std::string(walkTrialKindNames[0]), "", Range(),
            "forward, backward, sideways, turn, mixture (any requests) or push")
  PARAMETER(double, seconds, WalkTrialSetup().seconds, "s", Range(2, 600), "length of a try")
  PARAMETER(double, push, WalkTrialSetup().push, "m/s", Range(0, 3), "largest speed of a push")
  PARAMETER_GROUP(RobotOptions, robot, "robot and what its world is")
};

/// The walk of a robot type in one direction at full speed, any mixture of requests, or under pushes: what
/// bin/optimizewalk searches on one machine, as a task of the server. A run is one try,
/// of a direction also a shorter one of the cut sprint (alsoCut); its cost is walkCost. The file is the
/// type's walking.yaml. Figures: speed, falls, drift, lean (WalkTrialResult).
class WalkTask : public SearchTask {
public:
  using Options = WalkOptions;
  explicit WalkTask(const WalkOptions& options);
  ~WalkTask() override;

  const std::vector<TaskParameter>& parameters() const override { return parameters_; }
  TaskOutcome run(const Eigen::VectorXd& parameters, std::uint64_t seed) override;
  std::string file(const Eigen::VectorXd& parameters, const std::string& heading,
                   const std::map<std::string, double>& figures) const override;

private:
  walking::WalkGaits gaits(const Eigen::VectorXd& parameters) const;

  WalkTrialKind task_;
  WalkTrialSetup trial_;
  walking::WalkGaits first_;
  std::vector<WalkVariable> variables_;
  std::vector<TaskParameter> parameters_;
  std::unique_ptr<Walker> robot_;
};

}  // namespace plumbline::training
