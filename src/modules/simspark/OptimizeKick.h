#pragma once
#include <cstdint>
#include <optional>

#include "framework/Module.h"
#include "math/Random.h"
#include "modules/simspark/Monitor.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GroundTruth.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/modeling/FallState.h"
#include "representations/motion/MotionRequest.h"
#include "representations/motion/MotionSelection.h"
#include "representations/optimization/OptimizationResult.h"
#include "representations/optimization/OptimizationTrial.h"
#include "representations/optimization/SearchedMotionOutput.h"
#include "trials/AfterMotion.h"
#include "trials/KickMeasure.h"

namespace plumbline {

MODULE(OptimizeKick)
  REQUIRES(FrameInfo)
  REQUIRES(GroundTruth)
  REQUIRES(PlayerInfo)
  REQUIRES(FallState)
  REQUIRES(OptimizationTrial)
  USES(MotionSelection)
  USES(SearchedMotionOutput)
  PROVIDES(MotionRequest)
  PROVIDES(OptimizationResult)
  PARAMETER(double, standSeconds, 0.8, "s", Range(0.1, 10), "on its feet before the ball comes")
  PARAMETER(double, rollSeconds, 15, "s", Range(1, 60),
            "a ball that rolls for longer counts as stopped where it is then")
END_MODULE

/// Repeats the kick of the open trial, by the options of the task kick: a trainer puts robot and ball to
/// their places, the robot kicks and then walks or stands. The simulator's ground truth measures the ball. In
/// modules.cfg this module replaces behaviour and skills.
class OptimizeKick : public OptimizeKickBase {
public:
  void init() override;
  void update(MotionRequest* theMotionRequest) override;
  void update(OptimizationResult* theOptimizationResult) override { *theOptimizationResult = result_; }

private:
  enum class Phase { waiting, standing, ball, kicking, walking, rolling };

  void enter(Phase phase);
  void begin();
  void finish(const Vec2& ball);
  void decide();
  void placeRobot();
  void placeBall();
  void stand();
  void kick();
  void walk();
  void roll();
  bool command(bool sent);
  /// The same place in the server's field frame.
  Pose2 onField(const Pose2& place) const;
  double tilt() const;
  bool selected() const;

  Monitor* monitor_ = nullptr;
  Phase phase_ = Phase::waiting;
  double seconds_ = 0;  ///< in this phase
  double blind_ = 0;    ///< without ground truth [s]
  Random random_{0};
  Pose2 from_;         ///< of the robot when the ball was put
  Vec2 ball_, last_;   ///< where it was put, and where it was half a second ago [m]
  double lastAt_ = 0;  ///< time in the phase
  KickOptions options_;
  AfterMotion after_;
  std::optional<KickMeasure> measure_;
  double milliseconds_ = 0, error_ = 0;  ///< as KickMeasure::End
  int walked_ = 0;                       ///< cycles after the kick
  bool fell_ = false, up_ = false;       ///< in these, and at their end
  OptimizationResult result_;
};

}  // namespace plumbline
