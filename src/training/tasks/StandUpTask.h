#pragma once
#include <map>
#include <memory>

#include "motion/MotionParameters.h"
#include "training/SearchTask.h"
#include "training/tasks/TrialWorlds.h"
#include "trials/StandUpOptions.h"

namespace plumbline::training {

/// The robot lies on its front (1), back (-1) or a side (0).
bool liesAs(const MotionTrial& trial, int direction);

/// Standing up in the embedded simulator: Seekircher 2015, 3.1.1. In a run the robot lies as it fell (the
/// seed says how; not with limbs that overlap, which would freeze), plays the motion, and then walks into
/// some direction for two seconds. The cost is formula 3.1 with the opposite sign: angles between torso and
/// upright [rad], summed over the walk's cycles, plus the motion's time [ms] times `weight` (0.08). Figures:
/// time [ms] of the motion, error (the sum), up (1 if the torso leans by less than 30 degrees in the end).
/// From the side the time is of all motions.
class StandUpTask : public SearchTask {
public:
  using Options = StandUpOptions;
  explicit StandUpTask(const StandUpOptions& options);

  const std::vector<TaskParameter>& parameters() const override { return parameters_->list(); }
  TaskOutcome run(const Eigen::VectorXd& parameters, std::uint64_t seed) override;
  std::string file(const Eigen::VectorXd& parameters, const std::string& heading,
                   const std::map<std::string, double>& figures) const override;

  /// A run with any motion.
  TaskOutcome tryMotion(const motion::KeyframeMotion& motion, std::uint64_t seed);
  const motion::KeyframeMotion& first() const { return first_; }

private:
  using Lying = MotionTrial::State;
  const Lying& lying(std::uint64_t seed);
  /// The robot lies as this task wants it.
  bool fits(const MotionTrial& trial) const;
  bool falls(MotionTrial& trial, std::uint64_t seed) const;

  const StandUpOptions options_;
  const int direction_;  ///< 1: on the front, -1: on the back, 0: on a side
  const bool moving_;    ///< a run begins with the motion of the fall
  TrialWorlds worlds_;
  motion::KeyframeMotion first_;
  std::unique_ptr<motion::MotionParameters> parameters_;
  std::map<std::uint64_t, Lying> fallen_;  ///< falls cost as much as the rest and repeat within a generation
};

}  // namespace plumbline::training
