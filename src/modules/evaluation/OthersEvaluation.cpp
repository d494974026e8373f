#include "modules/evaluation/OthersEvaluation.h"

#include <fmt/format.h>

#include <cmath>

#include "modules/evaluation/PlayerFile.h"

namespace plumbline {

MAKE_MODULE(OthersEvaluation)

void OthersEvaluation::write(const char* belief, const char* what, int number, const Vec2& place,
                             double deviation, double age) {
  out_ << fmt::format("{:.2f},{},{},{},{:.3f},{:.3f},{:.3f},{:.2f},{:.2f}\n", theGameState->time, belief,
                      what, number, place.x(), place.y(), deviation,
                      (place - theRobotPose->pose.position).norm(), age);
}

void OthersEvaluation::writeRobots(const char* belief, const std::vector<OtherRobot>& robots) {
  for (const OtherRobot& robot : robots)
    write(belief, robot.mate ? "mate" : "opponent", robot.number, robot.position, robot.deviation(),
          theFrameInfo->time - robot.lastSeen);
}

void OthersEvaluation::execute() {
  const double time = theGameState->time;
  const bool runs = time > before_;
  before_ = time;
  if (!runs || time < next_ || thePlayerInfo->number < 1 || !theRobotPose->valid) return;
  next_ = (std::floor(time / interval) + 1) * interval;
  openPlayerFile(out_, folder, *thePlayerInfo, "time,belief,what,number,x,y,deviation,distance,age");
  const LocalBallPos& ball = *theLocalBallPos;
  if (ball.valid)
    write("alone", "ball", 0, theRobotPose->pose * ball.position, ball.deviation,
          theFrameInfo->time - ball.lastSeen);
  if (theBallPos->valid) write("team", "ball", 0, theBallPos->field, 0, theBallPos->age);
  writeRobots("alone", theLocalOtherRobots->robots);
  writeRobots("team", theOtherRobots->robots);
  out_.flush();
}

}  // namespace plumbline
