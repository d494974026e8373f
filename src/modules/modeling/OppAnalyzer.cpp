#include "modules/modeling/OppAnalyzer.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/DrawingSite.h"
#include "tactics/RollingBall.h"

namespace plumbline {

MAKE_MODULE(OppAnalyzer)

namespace {
constexpr double slowest = 0.3, fastest = 2;  ///< that a robot is taken to walk on the whole [m/s]
constexpr double kickSeconds = 0.5;           ///< within which a ball is seen as fast after a touch [s]
constexpr double farthestKick = 30;           ///< [m]; what seems farther was seen wrongly
}  // namespace

void OppAnalyzer::learnSpeed(OppInfo& info) {
  for (const OtherRobot& robot : theOtherRobots->robots) {
    if (robot.mate || robot.fallen || theFrameInfo->time - robot.lastSeen > seenSeconds) continue;
    const double speed = robot.velocity.norm();
    if (speed < walks || speed > fastest) continue;
    walkedWay_ += speed * theFrameInfo->cycleSeconds;
    walkedSeconds_ += theFrameInfo->cycleSeconds;
  }
  info.walkSpeed = std::clamp(
      (expectedSpeed * expectedSeconds + walkedWay_) / (expectedSeconds + walkedSeconds_), slowest, fastest);
}

void OppAnalyzer::findFirst(OppInfo& info) const {
  info.timeToBall = 1e3;
  info.nearest = 0;
  if (!theBallPos->valid) return;
  for (const OtherRobot& robot : theOtherRobots->robots) {
    if (robot.mate) continue;
    const double way = std::max(0.0, (robot.position - theBallPos->field).norm() - reach);
    const double seconds = way / info.walkSpeed + (robot.fallen ? getUp : 0);
    if (seconds >= info.timeToBall) continue;
    info.timeToBall = seconds;
    info.nearest = robot.number;
  }
}

/// A ball that rolls fast after only opponents were at it was kicked by them.
void OppAnalyzer::watchKick(OppInfo& info) {
  if (!theBallPos->valid || theBallPos->age > seenSeconds) return;
  const double now = theFrameInfo->time;
  bool ours = theBallPos->relative.norm() < reach, theirs = false;
  for (const OtherRobot& robot : theOtherRobots->robots)
    if ((robot.position - theBallPos->field).norm() < reach) (robot.mate ? ours : theirs) = true;
  if (ours) touchedByThem_ = -1;
  if (!ours && theirs) touchedByThem_ = now;
  const double speed = theBallPos->relativeVelocity.norm();
  if (touchedByThem_ < 0 || now - touchedByThem_ > kickSeconds || speed < kickSpeed) return;
  const double way = ballRollingSeconds * speed;
  if (way < farthestKick) info.kickDistance = std::max(info.kickDistance, way);
}

void OppAnalyzer::draw(const OppInfo& info) const {
  DEBUG_DRAWING("draw:OppAnalyzer:first", {
    for (const OtherRobot& robot : theOtherRobots->robots) {
      if (robot.mate || robot.number != info.nearest || info.nearest == 0) continue;
      drawing.arrow(robot.position, theBallPos->field, colours::red, 2);
      drawing.text(robot.position,
                   fmt::format("{:.1f} s, kicks {:.1f} m", info.timeToBall, info.kickDistance),
                   colours::white);
    }
  });
}

void OppAnalyzer::update(OppInfo* theOppInfo) {
  if (theFrameInfo->restarted) touchedByThem_ = -1;
  learnSpeed(*theOppInfo);
  findFirst(*theOppInfo);
  watchKick(*theOppInfo);
  draw(*theOppInfo);
}

}  // namespace plumbline
