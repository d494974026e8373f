#include "modules/behavior/Supporter.h"

#include <cmath>

namespace plumbline {

MAKE_MODULE(Supporter)

void Supporter::update(SupporterOutput* theSupporterOutput) {
  BehaviorOutput& output = *theSupporterOutput;
  output.clear();
  // A player that must not touch the ball again waits like a supporter, whatever its role.
  const bool waits = thePlayerRole->role == PlayerRole::striker && !thePlayerRole->mayTouchBall;
  output.active = (thePlayerRole->supports() || waits || thePlayerRole->role == PlayerRole::none) &&
                  thePlayerRole->members > 1 && theGameState->playMode != TeamPlayMode::gameOver &&
                  theGameState->playMode != TeamPlayMode::unknown;
  if (!output.active) {
    standing_ = false;
    return;
  }
  output.skill = Skill::moveToPos;
  const Pose2& robot = theRobotPose->pose;
  if (!theRobotPose->valid || !theBallPos->valid || theBallPos->age > ballMaxAge) {
    output.target =
        Pose2(robot.position,
              normalizeAngle(robot.heading + search_.turn(theBallPos->relative, theFrameInfo->time)));
    return;
  }
  const Vec2 toBall = theBallPos->field - robot.position;
  const double heading = std::atan2(toBall.y(), toBall.x());
  const Vec2 place = thePlayerRole->supports() ? thePlayerRole->place.position : robot.position;
  const double distance = (place - robot.position).norm();
  standing_ = distance < (standing_ ? leaves : arrived);
  if (!standing_) {
    output.target = Pose2(place, thePlayerRole->place.heading);
  } else if (std::abs(normalizeAngle(heading - robot.heading)) > facing) {
    output.target = Pose2(robot.position, heading);
  } else {
    output.skill = Skill::stand;
  }
}

}  // namespace plumbline
