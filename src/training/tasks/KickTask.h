#pragma once
#include <map>
#include <memory>

#include "motion/SearchedKick.h"
#include "training/SearchTask.h"
#include "training/tasks/BallRoll.h"
#include "training/tasks/TrialWorlds.h"

namespace plumbline::training {

/// A kick in the embedded simulator: Seekircher 2015, 3.1.1. In a run the robot has walked up and stopped, or
/// stands and sways (the seed says which and how). The ball lies within `spread` of where the kick wants it.
/// The robot plays the motion and walks at once for two seconds while the ball comes to rest.
/// The cost is motion::KickWish's; the wanted direction is forward.
/// Figures: distance (along) [m], direction (left of forward) [deg], off (its size), height [m], time [ms],
/// contact [ms] from the begin to the ball, error, up (1: leans by less than 30 degrees in the end), top (of
/// the ball between 3 and 8 m from where it lay, the highest) [m], low (1: that is below the goal's bar, and
/// the ball came so far).
/// Options: type 0 .., motion (a file's name to begin with), side (of the kicking foot), distance [m, 0: as
/// far as it goes], ceiling (of top, 0: none) [m], spread [m], weight (0.08), steady (1),
/// walk [s, 2: a shorter one makes a search faster], still (share of the runs in which the robot stands that
/// long instead of walking, 0), and TrialWorlds'.
class KickTask : public SearchTask {
public:
  explicit KickTask(const TaskOptions& options);

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

  const double spread_, walk_, still_;
  motion::KickWish wish_;
  TrialWorlds worlds_;
  BallRoll ball_;
  std::unique_ptr<motion::SearchedKick> kick_;
  std::map<std::uint64_t, Start> started_;  ///< repeat within a generation
};

}  // namespace plumbline::training
