#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "training/SearchTask.h"
#include "training/WalkTraining.h"

namespace plumbline::training {

/// The walk of a robot type in one direction at full speed, any mixture of requests, or under pushes: what
/// bin/optimizewalk searches on one machine, as a task of the server. A run is one try, its cost
/// walking::cost. The file is the type's walking.yaml.
/// Figures: speed, falls, drift (TrialResult).
/// Options: type 0 .., direction (one of walking::taskNames), seconds of a try (6), push (0.1) [m/s], engine,
/// effects (a file).
class WalkTask : public SearchTask {
public:
  explicit WalkTask(const TaskOptions& options);
  ~WalkTask() override;

  const std::vector<TaskParameter>& parameters() const override { return parameters_; }
  TaskOutcome run(const Eigen::VectorXd& parameters, std::uint64_t seed) override;
  std::string file(const Eigen::VectorXd& parameters, const std::string& heading,
                   const std::map<std::string, double>& figures) const override;

private:
  walking::WalkGaits gaits(const Eigen::VectorXd& parameters) const;

  walking::Task task_;
  walking::TrialSetup trial_;
  walking::WalkGaits first_;
  std::vector<walking::Variable> variables_;
  std::vector<TaskParameter> parameters_;
  std::unique_ptr<walking::Walker> robot_;
};

}  // namespace plumbline::training
