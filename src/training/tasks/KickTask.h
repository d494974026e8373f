#pragma once
#include <map>
#include <memory>

#include "training/MotionTrial.h"
#include "training/tasks/BallRoll.h"
#include "training/tasks/MotionParameters.h"

namespace plumbline::training {

/// A kick in the embedded simulator: Seekircher 2015, 3.1.1. A run: the robot has walked up and stopped, or
/// stands and sways (the seed says which and how); the ball lies within `spread` of where the kick wants it;
/// the robot plays the motion and walks at once for two seconds while the ball comes to rest.
/// The cost is formula 3.2 with the opposite sign and the ball's way split in two:
/// -30 (along - aside) - 120 min(1, height) + steady error + weight time; along and aside of the wanted
/// direction, which is forward, and height in metres, error as for standing up, time of the motion in ms.
/// With `distance` above 0: 30 |along - distance| in place of -30 along, and no worth of height.
/// Figures: distance (along) [m], direction (left of forward) [deg], off (its size), height [m], time [ms],
/// contact [ms] from the begin to the ball, error, up (1: leans by less than 30 degrees in the end).
/// Options: type 0 .., motion (a file's name to begin with), side (of the kicking foot), distance [m, 0: as
/// far as it goes], spread [m], weight (0.08), steady (1).
class KickTask : public SearchTask {
public:
  explicit KickTask(const TaskOptions& options);

  const std::vector<TaskParameter>& parameters() const override { return list_; }
  TaskOutcome run(const Eigen::VectorXd& parameters, std::uint64_t seed) override;
  std::string file(const Eigen::VectorXd& parameters, const std::string& heading,
                   const std::map<std::string, double>& figures) const override;

  /// A run with any motion whose `ball` says where it wants the ball.
  TaskOutcome tryMotion(const motion::KeyframeMotion& motion, std::uint64_t seed);
  const motion::KeyframeMotion& first() const { return first_; }

private:
  /// How the robot stands when the kick begins.
  struct Start {
    simulation::BodyState torso;
    JointArray angles{}, rates{};
  };
  const Start& start(std::uint64_t seed);
  bool walkUp();
  bool sway();
  motion::KeyframeMotion motionOf(const Eigen::VectorXd& parameters) const;

  const bool right_;
  const double distance_, spread_, weight_, steady_;
  motion::MotionTrial trial_;
  BallRoll ball_;
  motion::KeyframeMotion first_;
  std::unique_ptr<MotionParameters> motion_;
  std::vector<TaskParameter> list_;         ///< the motion's, then the ball's place [mm]
  std::map<std::uint64_t, Start> started_;  ///< repeat within a generation
};

}  // namespace plumbline::training
