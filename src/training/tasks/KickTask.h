#pragma once
#include <map>
#include <memory>

#include "motion/SearchedKick.h"
#include "training/SearchTask.h"
#include "training/tasks/BallRoll.h"
#include "training/tasks/TrialWorlds.h"
#include "trials/KickOptions.h"

namespace plumbline::training {

/// A kick in the embedded simulator: Seekircher 2015, 3.1.1. In a run the robot has walked to the ball and
/// stopped, or stands and sways (decided by the seed). The ball is within `spread` of the kick's ball
/// position. The robot plays the motion and then walks for two seconds while the ball stops. The cost is
/// motion::KickWish's, in the wanted direction.
/// Figures: KickMeasure's, and contact [ms] (from the beginning to the ball).
class KickTask : public SearchTask {
public:
  using Options = KickOptions;
  explicit KickTask(const KickOptions& options);

  const std::vector<TaskParameter>& parameters() const override { return kick_->list(); }
  TaskOutcome run(const Eigen::VectorXd& parameters, std::uint64_t seed) override;
  std::string file(const Eigen::VectorXd& parameters, const std::string& heading,
                   const std::map<std::string, double>& figures) const override;

  /// A run with any motion whose `ball` says where it wants the ball.
  TaskOutcome tryMotion(const motion::KeyframeMotion& motion, std::uint64_t seed);
  const motion::KeyframeMotion& first() const { return kick_->first(); }

private:
  /// How the robot stands when the kick begins.
  struct Start {
    simulation::BodyState torso;
    JointArray angles{}, rates{};
  };
  const Start& start(std::uint64_t seed);

  const KickOptions options_;
  TrialWorlds worlds_;
  BallRoll ball_;
  std::unique_ptr<motion::SearchedKick> kick_;
  std::map<std::uint64_t, Start> started_;  ///< repeat within a generation
};

}  // namespace plumbline::training
