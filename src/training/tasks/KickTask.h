#pragma once
#include <map>
#include <memory>

#include "motion/SearchedKick.h"
#include "training/SearchTask.h"
#include "training/tasks/BallRoll.h"
#include "training/tasks/TrialWorlds.h"

namespace plumbline::training {

/// A kick in the embedded simulator: Seekircher 2015, 3.1.1. In a run the robot has walked to the ball and
/// stopped, or stands and sways (decided by the seed). The ball is within `spread` of the kick's ball
/// position. The robot plays the motion and then walks for two seconds while the ball stops. The cost is
/// motion::KickWish's, in the wanted direction.
/// - Figures: distance (along the wanted direction) [m], direction (left of forward) [deg], off (from the
/// wanted direction, without its sign), height [m].
/// Further: time [ms], contact [ms] (from the beginning to the ball), error, up (1: leans by less than 30
/// degrees at the end). top is the ball's largest height between 3 and 8 m from its start [m]; low is 1 if
/// top is below the goal's bar and the ball came so far.
/// - Options: type 0 .., motion (name of the first file), side (of the kicking foot), direction (wanted, left
/// of forward) [deg, 0], distance [m, 0: as far as possible]. Further: ceiling (of top, 0: none) [m], spread
/// [m], weight (0.08), steady (1), walk [s, 2: a shorter one makes a search faster]. still is the share of
/// the runs in which the robot stands that long instead of walking (0). And the options of TrialWorlds.
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
  const double direction_;  ///< wanted, left of forward [rad]
  motion::KickWish wish_;
  TrialWorlds worlds_;
  BallRoll ball_;
  std::unique_ptr<motion::SearchedKick> kick_;
  std::map<std::uint64_t, Start> started_;  ///< repeat within a generation
};

}  // namespace plumbline::training
