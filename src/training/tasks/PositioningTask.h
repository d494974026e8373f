#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "motion/SearchedKickPlace.h"
#include "robot/KickEffect.h"
#include "tactics/approach/BallPositioning.h"
#include "training/SearchTask.h"
#include "training/SearchedGroup.h"
#include "training/tasks/BallRoll.h"
#include "training/tasks/TrialWorlds.h"

namespace plumbline::training {

/// Options of the task positioning.
struct PositioningOptions {
  PARAMETERS(PositioningOptions)
  PARAMETER(std::string, motion, "", "", Range(), "kick that is played; empty: the farthest of the robot")
  PARAMETER_CHOICE(searched, "all",
                   "which numbers: all, far (of the way from afar), near (of the last metres, and how "
                   "exactly it stands), place (of the kick)",
                   "all", "far", "near", "place")
  PARAMETER(double, start, 1.5, "m", Range(0.3, 10), "distance of the robot from the ball at the start")
  PARAMETER(double, farthest, 0.3, "m", Range(0.3, 10),
            "starts are drawn from `start` up to this distance, if it is larger; the numbers of a sprint "
            "matter from 2 m on")
  PARAMETER(double, metre, 0.5, "s", Range(0, 10),
            "worth of a metre that the ball comes less far along the wanted direction than the kick carries, "
            "or goes aside")
  PARAMETER(double, fall, 5, "s", Range(0, 100), "worth of a fall")
  PARAMETER_GROUP(WorldOptions, world, "robot and worlds")
};

/// Kick positioning (Seekircher 2015, 3.1.2): the robot stands 1.5 m from the ball in any direction with any
/// heading, walks there and kicks. Searched are numbers of BallPositioningParameters; the file is the type's
/// SkillGetBall.yaml. Or searched are the kick's own place of the ball and its direction
/// (motion::SearchedKickPlace): a robot that stops at the ball stands a little off in its own way. The file
/// is then the kick's.
///
/// The cost of a run is formula 3.3 with the opposite sign, in seconds. It is the time to the kick and
/// `fall` seconds for a fall. To that come `metre` seconds for each metre that the ball comes less far along
/// the wanted direction than the kick carries, or goes aside. Figures: time to the kick [s], distance along
/// and aside [m], kicked, fell.
class PositioningTask : public SearchTask {
public:
  using Options = PositioningOptions;
  explicit PositioningTask(const PositioningOptions& options);

  const std::vector<TaskParameter>& parameters() const override {
    return place_ ? place_->list() : searched_.parameters();
  }
  TaskOutcome run(const Eigen::VectorXd& parameters, std::uint64_t seed) override;
  std::string file(const Eigen::VectorXd& parameters, const std::string& heading,
                   const std::map<std::string, double>& figures) const override;

private:
  struct Walk;

  int type_;  ///< of the robot
  TrialWorlds worlds_;
  BallRoll ball_;
  motion::KeyframeMotion kick_;             ///< with the right foot
  double start_, farthest_, metre_, fall_;  ///< options [m, m, s, s]
  SearchedGroup<BallPositioningParameters> searched_;
  std::optional<motion::SearchedKickPlace> place_;  ///< where that is searched
};

}  // namespace plumbline::training
