#pragma once
#include <map>
#include <memory>

#include "motion/SearchedKick.h"
#include "training/SearchTask.h"
#include "training/tasks/BallRoll.h"
#include "training/tasks/TrialWorlds.h"

namespace plumbline::training {

/// Options of the task kick.
struct KickOptions {
  PARAMETERS(KickOptions)
  PARAMETER(std::string, motion, "kickRight", "", Range(), "kick to begin with")
  PARAMETER_CHOICE(side, "right", "kicking foot", "right", "left")
  PARAMETER(double, direction, 0, "deg", Range(-180, 180), "where the ball is to go, to the left of forward")
  PARAMETER_GROUP(motion::KickWish, wish, "what is wanted of the kick")
  PARAMETER(double, spread, 0.01, "m", Range(0, 0.1),
            "largest offset of the ball to each side; the thesis's square has 2 x 2 cm")
  PARAMETER(double, walk, 2, "s", Range(0.2, 10),
            "time of the walk after the kick; a shorter one makes a search faster, not its result better")
  PARAMETER(double, still, 0, "", Range(0, 1),
            "share of the runs in which the robot stands for that time instead of walking: a walk hides that "
            "a robot would fall")
  PARAMETER_GROUP(WorldOptions, world, "robot and worlds")
};

/// A kick in the embedded simulator: Seekircher 2015, 3.1.1. In a run the robot has walked to the ball and
/// stopped, or stands and sways (decided by the seed). The ball is within `spread` of the kick's ball
/// position. The robot plays the motion and then walks for two seconds while the ball stops. The cost is
/// motion::KickWish's, in the wanted direction.
/// - Figures: distance (along the wanted direction) [m], direction (left of forward) [deg], off (from the
/// wanted direction, without its sign), height [m].
/// Further: time [ms], contact [ms] (from the beginning to the ball), error, up (1: leans by less than 30
/// degrees at the end). top is the ball's largest height between 3 and 8 m from its start [m]; low is 1 if
/// top is below the goal's bar and the ball came so far.
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
  const double direction_;  ///< wanted, left of forward [rad]
  TrialWorlds worlds_;
  BallRoll ball_;
  std::unique_ptr<motion::SearchedKick> kick_;
  std::map<std::uint64_t, Start> started_;  ///< repeat within a generation
};

}  // namespace plumbline::training
