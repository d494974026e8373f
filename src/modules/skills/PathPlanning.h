#pragma once
#include <optional>
#include <vector>

#include "framework/Drawing.h"
#include "framework/Module.h"
#include "modules/skills/path/PathPlanner.h"
#include "representations/behavior/PlayerRole.h"
#include "representations/behavior/SkillRequest.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"
#include "representations/skills/SafeWalkDirection.h"
#include "representations/skills/SkillOutput.h"
#include "tactics/OwnArea.h"

namespace plumbline {

MODULE(PathPlanning)
  REQUIRES(FrameInfo)
  REQUIRES(SkillRequest)
  USES_ALL(SkillOutput)
  REQUIRES(FieldDimensions)
  REQUIRES(PlayerInfo)
  REQUIRES(PlayerRole)
  REQUIRES(RobotPose)
  REQUIRES(BallPos)
  REQUIRES(OtherRobots)
  PROVIDES(SafeWalkDirection)
  PARAMETER_GROUP(PathPlannerParameters, planner, "the search for the way")
  PARAMETER(double, robotRadius, 0.42, "m", Range(0.1, 3), "kept from the middle of a robot that stands")
  PARAMETER(double, fallenRadius, 0.65, "m", Range(0.1, 3), "kept from the middle of one that lies")
  PARAMETER(double, postRadius, 0.35, "m", Range(0.05, 3), "kept from a goal post")
  PARAMETER(double, ballRadius, 0.45, "m", Range(0.05, 3),
            "distance from the ball of players that do not go to it")
  PARAMETER(double, ownSpeed, 0.7, "m/s", Range(0.05, 3),
            "speed with which the robot meets others at their predicted places")
  PARAMETER(double, foresight, 1, "s", Range(0, 10), "others are predicted no farther")
  PARAMETER(double, oldestSight, 3, "s", Range(0.1, 60),
            "robots heard of or seen before this time are not obstacles")
  PARAMETER(double, waitDistance, 0.6, "m", Range(0, 3),
            "nearer than this to a mate ahead that goes before, the robot waits")
  PARAMETER(double, destinationRadius, 0.7, "m", Range(0, 5),
            "robots this near to the ball are none for the one that goes to it")
END_MODULE

/// Finds the path to the target of the requested skill, round other robots and goal posts, and round the ball
/// for players that do not go to it. Nor does a way lead through the own penalty area without the right to be
/// there (PlayerRole). The thesis plans with random trees; this uses a visibility graph
/// (PathPlanner). Of two mates the striker has priority, then the lower number; the other one waits.
class PathPlanning : public PathPlanningBase {
public:
  void update(SafeWalkDirection* theSafeWalkDirection) override;

private:
  enum class Destination { none, place, ball };
  Destination destination() const;
  Obstacles obstacles(Destination to, const Vec2& goal) const;
  bool mateGoesBefore(const Vec2& direction) const;
  void drawWay(Drawing& drawing, const Vec2& goal, const Obstacles& all) const;

  Vec2 last_ = Vec2::Zero();  ///< direction of the last way, field
};

}  // namespace plumbline
