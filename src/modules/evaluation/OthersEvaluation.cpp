#include "modules/evaluation/OthersEvaluation.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "modules/evaluation/OutputProblems.h"

namespace plumbline {

MAKE_MODULE(OthersEvaluation)

OthersEvaluation::OthersEvaluation()
    : file_("the estimates", "time,belief,what,number,x,y,deviation,distance,age") {}

void OthersEvaluation::init() {
  try {
    PlayerFile::prepare(folder);
  } catch (const std::runtime_error& error) {
    refuse("folder", error.what());
  }
}

void OthersEvaluation::add(const char* belief, const char* what, int number, const Vec2& place,
                           double deviation, double age) {
  lines_ +=
      fmt::format("{:.2f},{},{},{},{:.3f},{:.3f},{:.3f},{:.2f},{:.2f}\n", theGameState->time, belief, what,
                  number, place.x(), place.y(), deviation, (place - theRobotPose->pose.position).norm(), age);
}

void OthersEvaluation::addRobots(const char* belief, const std::vector<OtherRobot>& robots) {
  for (const OtherRobot& robot : robots)
    add(belief, robot.mate ? "mate" : "opponent", robot.number, robot.position, robot.deviation(),
        theFrameInfo->time - robot.lastSeen);
}

void OthersEvaluation::execute() {
  const double time = theGameState->time;
  const bool runs = time > before_;
  before_ = time;
  if (!runs || time < next_ || thePlayerInfo->number < 1 || !theRobotPose->valid) return;
  next_ = (std::floor(time / interval) + 1) * interval;
  lines_.clear();
  const LocalBallPos& ball = *theLocalBallPos;
  if (ball.valid)
    add("alone", "ball", 0, theRobotPose->pose * ball.position, ball.deviation,
        theFrameInfo->time - ball.lastSeen);
  if (theBallPos->valid) add("team", "ball", 0, theBallPos->field, 0, theBallPos->age);
  addRobots("alone", theLocalOtherRobots->robots);
  addRobots("team", theOtherRobots->robots);
  file_.write(folder, *thePlayerInfo, lines_, object<OutputProblems>());
}

}  // namespace plumbline
