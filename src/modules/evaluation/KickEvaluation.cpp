#include "modules/evaluation/KickEvaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "math/GroundPose.h"
#include "modules/evaluation/OutputProblems.h"

namespace plumbline {

MAKE_MODULE(KickEvaluation)

KickEvaluation::KickEvaluation()
    : file_("the kicks", "time,kick,foot,x,y,believedX,believedY,heading,way,direction") {}

void KickEvaluation::init() {
  try {
    PlayerFile::prepare(folder);
  } catch (const std::runtime_error& error) {
    refuse("folder", error.what());
  }
}

void KickEvaluation::begin() {
  const std::string& name = theMotionRequest->kick;
  const auto& kicks = theSkillKickParameters->kicks;
  const auto kick = std::ranges::find(kicks, name, &Kick::motion);
  if (kick == kicks.end()) return;
  const bool left = theMotionRequest->kickFoot == Side::left;
  const auto fromPlace = [&](Vec2 ball) {
    if (left) ball.y() = -ball.y();
    return Vec2(ball - kick->ballPosition);
  };
  const Pose2 robot = groundPose(theGroundTruth->T_field_torso);
  const Vec2 real = fromPlace(robot.inverse() * ball_), believed = fromPlace(theMotionRequest->kickBall);
  const double heading = toDegrees(normalizeAngle(theRobotPose->pose.heading - robot.heading));
  begun_ = {fmt::format("{:.2f},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.2f}", theFrameInfo->time, name,
                        left ? "left" : "right", real.x(), real.y(), believed.x(), believed.y(), heading),
            theFrameInfo->time, robot, ball_};
}

void KickEvaluation::finish() {
  if (!begun_) return;
  const Vec2 way = ball_ - begun_->ball;
  const double direction = normalizeAngle(std::atan2(way.y(), way.x()) - begun_->robot.heading);
  file_.write(folder, *thePlayerInfo,
              fmt::format("{},{:.2f},{:.1f}\n", begun_->line, way.norm(), toDegrees(direction)),
              object<OutputProblems>());
  begun_.reset();
}

void KickEvaluation::execute() {
  if (!theGroundTruth->valid) return;
  ball_ = theGroundTruth->ball.head<2>();
  const bool starts = theMotionSelection->started && theMotionSelection->motion == Motion::kick;
  if (begun_ && (starts || theFrameInfo->time - begun_->time > seconds)) finish();
  if (starts) begin();
}

}  // namespace plumbline
