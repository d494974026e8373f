#pragma once
#include <memory>

#include "motion/MotionParameters.h"
#include "training/tasks/TrialWorlds.h"

namespace plumbline::training {

/// A shot at a keeper that stands at the origin and looks along x.
struct Shot {
  Vec2 from, velocity;  ///< of the ball when the dive begins [m, m/s]
  double seconds = 0;   ///< until it crosses the keeper's line
  double aside = 0;     ///< where it crosses, to the side of the dive [m]
};

/// A keeper's fall to its right into the way of a shot. A run is one shot past the keeper's right side; its
/// cost is 1 for a ball that gets past, else 0, and `weight` for each second of the motion.
class DiveTask : public SearchTask {
public:
  /// Options: type, motion, least, most (where shots cross [m]), soonest, latest (when [s]), weight, and
  /// those of TrialWorlds. Throws ConfigurationError.
  explicit DiveTask(const TaskOptions& options);

  const std::vector<TaskParameter>& parameters() const override { return parameters_->list(); }
  TaskOutcome run(const Eigen::VectorXd& parameters, std::uint64_t seed) override;
  std::string file(const Eigen::VectorXd& parameters, const std::string& heading,
                   const std::map<std::string, double>& figures) const override;

  Shot shotOf(std::uint64_t seed);
  /// With a motion as it is; none: the keeper stands.
  TaskOutcome tryMotion(const motion::KeyframeMotion* dive, std::uint64_t seed);

private:
  double least_, most_, soonest_, latest_, weight_;
  TrialWorlds worlds_;
  motion::KeyframeMotion first_;
  std::unique_ptr<motion::MotionParameters> parameters_;
};

}  // namespace plumbline::training
