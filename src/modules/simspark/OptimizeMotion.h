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
#include "representations/optimization/FallOverOutput.h"
#include "representations/optimization/OptimizationResult.h"
#include "representations/optimization/OptimizationTrial.h"
#include "representations/optimization/SearchedMotionOutput.h"
#include "trials/AfterMotion.h"
#include "trials/KickMeasure.h"
#include "trials/StandUpOptions.h"

namespace plumbline {

MODULE(OptimizeMotion)
  REQUIRES(FrameInfo)
  REQUIRES(GroundTruth)
  REQUIRES(PlayerInfo)
  REQUIRES(FallState)
  REQUIRES(OptimizationTrial)
  USES(MotionSelection)
  USES(SearchedMotionOutput)
  PROVIDES(MotionRequest)
  PROVIDES(OptimizationResult)
  PARAMETER(double, standSeconds, 0.8, "s", Range(0.1, 10), "on its feet before the ball comes or it falls")
  PARAMETER(double, rollSeconds, 15, "s", Range(1, 60),
            "a ball that rolls for longer counts as stopped where it is then")
END_MODULE

/// Repeats the motion of the open trial, by the options of its task. A trainer puts robot and ball to their
/// places; the robot kicks, or falls and stands up, and then walks or stands. The simulator's ground truth
/// measures ball and robot. In modules.cfg this module replaces behaviour and skills.
class OptimizeMotion : public OptimizeMotionBase {
public:
  void init() override;
  void update(MotionRequest* theMotionRequest) override;
  void update(OptimizationResult* theOptimizationResult) override { *theOptimizationResult = result_; }

private:
  enum class Phase { waiting, standing, ball, falling, playing, walking, rolling };

  void enter(Phase phase);
  void begin();
  void finish(const TaskOutcome& outcome);
  void decide();
  void placeRobot();
  void placeBall();
  void stand();
  void fall();
  void play();
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
  Pose2 from_;                       ///< of the robot when the ball was put
  Vec2 ball_, last_;                 ///< where it was put, and where it was half a second ago [m]
  double lastAt_ = 0;                ///< time in the phase
  std::optional<KickOptions> kick_;  ///< of the open trial, if it is a kick
  std::optional<StandUpOptions> standUp_;
  double direction_ = 0;  ///< of a kick, left of forward [rad]
  double lies_ = 0;       ///< for so long as the task wants it [s]
  AfterMotion after_;
  std::optional<KickMeasure> measure_;
  double milliseconds_ = 0, error_ = 0;  ///< as KickMeasure::End
  int walked_ = 0;                       ///< cycles after the motion
  bool up_ = false;                      ///< at their end
  OptimizationResult result_;
};

}  // namespace plumbline
