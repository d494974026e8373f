#pragma once
#include <optional>
#include <string>

#include "framework/Module.h"
#include "math/Pose2.h"
#include "modules/evaluation/PlayerFile.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GroundTruth.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/modeling/RobotPose.h"
#include "representations/motion/MotionRequest.h"
#include "representations/motion/MotionSelection.h"
#include "representations/skills/SkillKickParameters.h"

namespace plumbline {

MODULE(KickEvaluation)
  REQUIRES(FrameInfo)
  REQUIRES(PlayerInfo)
  REQUIRES(GroundTruth)
  REQUIRES(RobotPose)
  REQUIRES(SkillKickParameters)
  REQUIRES(MotionRequest)
  REQUIRES(MotionSelection)
  PARAMETER(std::string, folder, "build/run/kicks", "", Range(),
            "a file of each player, a line for each kick")
  PARAMETER(double, seconds, 4, "s", Range(0.1, 60), "after which the ball's way is measured")
END_MODULE

/// Writes for each kick where the ball lay when it began, truly and as the robot believed, relative to where
/// the kick wants it, and how far the ball went. Only where modules.cfg asks for it. Files: left-5.csv.
///
/// Columns: time [s], kick and foot. x, y: where the ball was, in the robot's ground frame, from the kick's
/// place on [m]. y is to the left for a right foot and to the right for a left one. believedX, believedY: the
/// same as the robot believed. heading: believed less true [deg]. way and direction: of the ball then, to the
/// left of the robot's heading at the beginning [m, deg].
class KickEvaluation : public KickEvaluationBase {
public:
  KickEvaluation();
  ~KickEvaluation() override { finish(); }
  void init() override;
  void execute() override;

private:
  struct Begun {
    std::string line;
    double time = 0;
    Pose2 robot;
    Vec2 ball = Vec2::Zero();
  };
  void begin();
  void finish();

  PlayerFile file_;
  std::optional<Begun> begun_;
  Vec2 ball_ = Vec2::Zero();  ///< where it is now, truly [m]
};

}  // namespace plumbline
