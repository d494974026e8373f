#pragma once
#include "framework/Module.h"
#include "representations/behavior/BehaviorOutputs.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/GameState.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/RobotPose.h"
#include "representations/skills/SkillKickParameters.h"

namespace plumbline {

MODULE(Striker2)
REQUIRES(GameState)
REQUIRES(RobotPose)
REQUIRES(BallPos)
REQUIRES(FieldDimensions)
REQUIRES(SkillKickParameters)
PROVIDES(StrikerOutput)
END_MODULE

/// The player at the ball: kicks at the goal in reach, else brings the ball there; searches a lost ball and
/// keeps its distance at the opponent's restarts.
class Striker2 : public Striker2Base {
public:
  void init() override;
  void update(StrikerOutput* theStrikerOutput) override;

private:
  /// The line from the ball that splits the angle between the posts.
  struct Shot {
    Vec2 target = Vec2::Zero();  ///< a point on it as far as the goal [m, field]
    double halfOpening = 0;      ///< half the angle between the posts [rad]
    double distance = 0;         ///< of ball and goal [m]
  };
  Shot shot() const;

  bool kickAllowed_ = true;
  double ballMaxAge_ = 0;       ///< [s]
  double restartDistance_ = 0;  ///< from the ball at the opponent's restarts [m]
  double goalMargin_ = 0;       ///< aimed at least this far inside the posts [m]
  double minOpening_ = 0;       ///< a narrower goal in reach is dribbled at [rad]
  double dribbleDistance_ = 0;  ///< closer to the goal than this the ball is dribbled in [m]
};

}  // namespace plumbline
