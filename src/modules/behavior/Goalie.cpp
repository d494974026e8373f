#include "modules/behavior/Goalie.h"

#include <algorithm>
#include <cmath>

#include "tactics/RollingBall.h"

namespace plumbline {

MAKE_MODULE(Goalie)

namespace {
constexpr double lineMargin = 0.25;  ///< kept before the goal line [m]
constexpr double facing = 0.35;      ///< the ball farther aside is turned to [rad]
}  // namespace

Vec2 Goalie::onAngle() const {
  const double line = -theFieldDimensions->length / 2, post = theFieldDimensions->goalWidth / 2;
  const Vec2& ball = theBallPos->field;
  const Vec2 toLeft = Vec2(line, post) - ball, toRight = Vec2(line, -post) - ball;
  // The line that halves the angle meets the goal line nearer to the post that is nearer to the ball.
  const double left = toLeft.norm(), right = toRight.norm();
  const Vec2 centre(line, left + right > 1e-6 ? post - 2 * post * left / (left + right) : 0);
  Vec2 out = ball - centre;
  const double distance = out.norm();
  out = distance > 1e-3 ? Vec2(out / distance) : Vec2(Vec2::UnitX());
  const double share = std::clamp((distance - nearBall) / std::max(farBall - nearBall, 0.1), 0.0, 1.0);
  const double away = std::min(std::lerp(nearOut, farOut, share), std::max(distance - 0.3, 0.0));
  Vec2 place = centre + away * out;
  place.x() = std::max(place.x(), line + lineMargin);
  place.y() = std::clamp(place.y(), -post, post);
  return place;
}

bool Goalie::shotCrossing(Vec2& place) const {
  const Vec2 velocity = theRobotPose->pose.rotation() * theBallPos->relativeVelocity;
  const double line = place.x();
  const double ahead = theBallPos->field.x() - line;
  if (velocity.x() > -shotSpeed || ahead <= 0 || -velocity.x() * ballRollingSeconds < ahead) return false;
  const double y = theBallPos->field.y() + velocity.y() * ahead / -velocity.x();
  if (std::abs(y) > theFieldDimensions->goalWidth / 2 + 0.3) return false;
  place.y() = y;
  return true;
}

std::optional<double> Goalie::diveAside() const {
  const Vec2 &ball = theBallPos->relative, &velocity = theBallPos->relativeVelocity;
  const double run = -velocity.x() * ballRollingSeconds;  // as far as it rolls towards the robot
  if (!dives || velocity.x() > -shotSpeed || ball.x() <= 0 || run <= ball.x()) return std::nullopt;
  const double seconds = -ballRollingSeconds * std::log1p(-ball.x() / run);
  const double aside = ball.y() + velocity.y() * ball.x() / -velocity.x();
  const double stepped = standingReach + stepSpeed * std::max(0.0, seconds - stepDelay);
  if (seconds > diveSeconds || std::abs(aside) < stepped || std::abs(aside) > diveReach) return std::nullopt;
  return aside;
}

void Goalie::update(GoalieOutput* theGoalieOutput) {
  BehaviorOutput& output = *theGoalieOutput;
  output.clear();
  const bool plays =
      theGameState->playMode != TeamPlayMode::gameOver && theGameState->playMode != TeamPlayMode::unknown;
  const bool keeps = plays && thePlayerRole->role == PlayerRole::goalie;
  if (!keeps && !(plays && thePlayerRole->keeper)) {
    standing_ = false;
    sure_ = 0;
    return;
  }
  const Pose2& robot = theRobotPose->pose;
  const bool lost = !theBallPos->valid || theBallPos->age > ballMaxAge;
  Vec2 place = lost ? Vec2(-theFieldDimensions->length / 2 + nearOut, 0) : onAngle();
  const bool shot = theRobotPose->valid && !lost && shotCrossing(place);
  // Near its goal it may be the striker, and go to a ball that it then has to stop.
  const std::optional<double> aside = shot && thePlayerRole->keeper ? diveAside() : std::nullopt;
  const double side = aside ? std::copysign(1.0, *aside) : 0;
  if (side * sure_ <= 0) sure_ = 0;
  sure_ += side * theFrameInfo->cycleSeconds;
  if (aside && std::abs(sure_) > sureSeconds) {
    output.active = true;
    output.skill = Skill::dive;
    output.target = Pose2(robot * Vec2(0, *aside), robot.heading);
    standing_ = false;
    return;
  }
  output.active = keeps;
  if (!keeps) {
    standing_ = false;
    return;
  }
  output.skill = Skill::moveToPos;
  if (!theRobotPose->valid) {
    output.target = Pose2(robot.position, normalizeAngle(robot.heading + 1.0));
    return;
  }
  const double distance = (place - robot.position).norm();
  standing_ = !shot && distance < (standing_ ? leaves : tolerance);
  const Vec2 toBall = theBallPos->field - place;
  const double heading = lost ? 0 : std::atan2(toBall.y(), toBall.x());
  if (standing_ && std::abs(normalizeAngle(heading - robot.heading)) < facing)
    output.skill = Skill::stand;
  else
    output.target = Pose2(standing_ ? robot.position : place, heading);
}

}  // namespace plumbline
