#include "modules/communication/BeliefShare.h"

#include <algorithm>
#include <cmath>

#include "framework/DrawingSite.h"
#include "modules/modeling/ball/TeamBall.h"
#include "modules/modeling/others/RobotDrawing.h"
#include "tactics/RollingBall.h"

namespace plumbline {

MAKE_MODULE(BeliefShare)

namespace {

void addOpponent(TeamBelief& belief, int number, const Vec2& position) {
  SaidOpponent& heard = belief.opponents.emplace_back();
  heard.number = number;
  heard.position = position;
}

}  // namespace

void BeliefShare::remember(const TeamBelief& belief, double time) {
  TeamReport& report = reports_[static_cast<std::size_t>(belief.number)];
  report.belief = belief;
  report.time = time;
}

void BeliefShare::execute() {
  if (theFrameInfo->restarted) {
    reports_ = {};
    opponents_ = {};
    saidBefore_ = -1;
  }
  const double now = theFrameInfo->time;
  for (const TeamBelief& belief : theTeamComDataIn->beliefs) {
    if (!isUniformNumber(belief.number)) continue;
    remember(belief, now);
    for (const SaidOpponent& said : belief.opponents) {
      OtherRobot& opponent = opponents_[static_cast<std::size_t>(said.number)];
      opponent.number = said.number;
      opponent.position = said.position;
      opponent.lastSeen = now;
    }
  }
  if (theSayMessage && theSayMessage->time > saidBefore_) {
    saidBefore_ = theSayMessage->time;
    const TeamBelief& said = theSayMessage->said;
    if (isUniformNumber(said.number)) remember(said, saidBefore_);
    if (!said.opponents.empty()) lastShared_ = said.opponents.back().number;
  }
}

void BeliefShare::update(TeamRobotPose* theTeamRobotPose) {
  theTeamRobotPose->reports.clear();
  for (const TeamReport& report : reports_)
    if (report.time >= 0 && theFrameInfo->time - report.time <= memorySeconds)
      theTeamRobotPose->reports.push_back(report);
}

void BeliefShare::update(TeamBallPos* theTeamBallPos) {
  std::vector<HeardBall> heard;
  for (const TeamReport& report : reports_) {
    const TeamBelief& belief = report.belief;
    const double passed = theFrameInfo->time - report.time;
    if (report.time < 0 || passed > memorySeconds || belief.number == thePlayerInfo->number) continue;
    if (!belief.ballKnown || !belief.localised) continue;
    const double age = belief.ballAge + passed;
    const double noise = std::hypot(poseNoise, rangeNoise * (belief.ball - belief.pose.position).norm());
    heard.push_back({rolledOn(belief.ball, belief.ballVelocity, age), belief.ballVelocity,
                     std::hypot(noise, ballDrift * age), age});
  }
  const auto ball = combineBalls(heard);
  theTeamBallPos->valid = ball.has_value();
  if (!ball) return;
  theTeamBallPos->field = ball->position;
  theTeamBallPos->velocity = ball->velocity;
  theTeamBallPos->deviation = ball->deviation;
  theTeamBallPos->age = ball->age;
}

void BeliefShare::update(TeamOtherRobots* theTeamOtherRobots) {
  theTeamOtherRobots->robots.clear();
  const auto add = [&](OtherRobot robot, double time) {
    const double passed = theFrameInfo->time - time;
    const double deviation = std::hypot(poseNoise, robotDrift * passed);
    robot.covariance = deviation * deviation * Mat2::Identity();
    robot.lastSeen = time;
    theTeamOtherRobots->robots.push_back(robot);
  };
  for (const TeamReport& report : reports_) {
    if (report.time < 0 || theFrameInfo->time - report.time > memorySeconds) continue;
    if (report.belief.number == thePlayerInfo->number || !report.belief.localised) continue;
    OtherRobot mate;
    mate.mate = true;
    mate.number = report.belief.number;
    mate.position = report.belief.pose.position;
    mate.fallen = report.belief.fallen;
    add(mate, report.time);
  }
  for (const OtherRobot& opponent : opponents_)
    if (opponent.lastSeen >= 0 && theFrameInfo->time - opponent.lastSeen <= opponentSeconds)
      add(opponent, opponent.lastSeen);
  DEBUG_DRAWING("draw:belief:heard", drawRobots(drawing, theTeamOtherRobots->robots, beliefColours::heard));
}

void BeliefShare::addOpponents(TeamBelief& belief) const {
  // In turn by number, beginning after the one that was sent last.
  for (int i = 1; i <= teamSize && belief.opponents.size() < TeamBelief::maxOpponents; ++i) {
    const int number = (lastShared_ + i - 1) % teamSize + 1;
    for (const OtherRobot& robot : theLocalOtherRobots->robots)
      if (!robot.mate && robot.number == number && theFrameInfo->time - robot.lastSeen <= seenSeconds)
        addOpponent(belief, number, robot.position);
  }
}

void BeliefShare::update(TeamComDataOut* theTeamComDataOut) {
  TeamBelief& belief = theTeamComDataOut->belief;
  belief = TeamBelief();
  belief.number = thePlayerInfo->number;
  belief.pose = theRobotPose->pose;
  belief.localised = theRobotPose->valid;
  belief.fallen = theFallState->lying();
  if (thePlayerRole) {
    belief.role = thePlayerRole->role;
    belief.timeToBall = thePlayerRole->timeToBall;
  }
  if (!theRobotPose->valid) return;
  const LocalBallPos& ball = *theLocalBallPos;
  belief.ballKnown = ball.valid && ball.lastSeen >= 0;
  belief.ballAge = theFrameInfo->time - ball.lastSeen;
  belief.ball = theRobotPose->pose * ball.position;
  belief.ballVelocity = theRobotPose->pose.rotation() * ball.velocity;
  addOpponents(belief);
}

}  // namespace plumbline
