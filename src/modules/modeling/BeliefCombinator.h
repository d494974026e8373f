#pragma once
#include "framework/Drawing.h"
#include "framework/Module.h"
#include "representations/communication/TeamReports.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"

namespace plumbline {

MODULE(BeliefCombinator)
  REQUIRES(FrameInfo)
  REQUIRES(RobotPose)
  REQUIRES(LocalBallPos)
  REQUIRES_IF_PROVIDED(TeamBallPos)
  REQUIRES_IF_PROVIDED(LocalOtherRobots)
  REQUIRES_IF_PROVIDED(TeamOtherRobots)
  PROVIDES(BallPos)
  PROVIDES(OtherRobots)
  PARAMETER(double, ownBallSeconds, 0.6, "s", Range(0, 100),
            "if this robot saw the ball within this time, it does not use balls of mates")
  PARAMETER(double, ownRobotSeconds, 0.3, "s", Range(0, 100), "the same of other robots")
  PARAMETER(double, freshSeconds, 0.1, "s", Range(0, 100),
            "a ball not seen for longer is kept at its place on the field")
END_MODULE

/// The ball to act on: what this robot tracks, placed on the field. A ball that has not been seen for a while
/// is kept at its place on the field rather than relative to the robot, because the self-localisation does
/// not drift and the odometry does. A mate's ball counts if the mate saw it later than this robot did. Other
/// robots are weighted by their covariances. Without messages of mates, only the own sight counts.
class BeliefCombinator : public BeliefCombinatorBase {
public:
  void update(BallPos* theBallPos) override;
  void update(OtherRobots* theOtherRobots) override;

private:
  void roll(double dt);
  void hear(BallPos& ball);
  void drawBall(Drawing& drawing, const BallPos& ball) const;

  bool onField_ = false;                                    ///< position_ and velocity_ are known
  Vec2 position_ = Vec2::Zero(), velocity_ = Vec2::Zero();  ///< on the field [m, m/s]
};

}  // namespace plumbline
