#include "motion/MotionParameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/CommentLines.h"
#include "math/Angle.h"
#include "motion/KeyframeReader.h"
#include "robot/BodyJoints.h"

namespace plumbline::motion {
namespace {

constexpr double longest = 1000;                                     // [ms] of a keyframe
constexpr double timeSigma = 25, settleSigma = 120, angleSigma = 5;  // [ms, ms, degrees]
constexpr double limitMargin = 0.1;                                  // [degrees]: the file rounds

/// Whether the joint and its partner, which one key can name, are mirror images.
bool mirrors(const Keyframe& frame, JointId joint, const RobotModel& robot) {
  const JointId other = mirrored(joint);
  return other != joint && frame.set[other] && !bothSides(robot, std::min(joint, other)).empty() &&
         std::abs(frame.angles[other] - mirrorSign(joint) * frame.angles[joint]) < 1e-9;
}

std::string nameOf(const RobotModel& robot, JointId joint, bool both) {
  return both ? bothSides(robot, joint) : std::string(robot.jointName(joint));
}

}  // namespace

MotionParameters::MotionParameters(KeyframeMotion motion, const RobotModel& robot, Sides sides)
    : motion_(std::move(motion)), sides_(sides) {
  for (std::size_t i = 0; i < motion_.keyframes.size(); ++i) {
    const Keyframe& frame = motion_.keyframes[i];
    const std::string number = std::to_string(i + 1);
    add({i, Place::What::seconds}, "time" + number, 1e3 * frame.seconds, 0,
        std::max(longest, 1e3 * frame.seconds), timeSigma);
    if (frame.settleSeconds > 0)
      add({i, Place::What::settle}, "settle" + number, 1e3 * frame.settleSeconds, 0, longest, settleSigma);
    for (int j = firstBodyJoint; j < maxJoints; ++j) {
      const auto joint = static_cast<JointId>(j);
      if (!frame.set[joint] || !robot.has(joint)) continue;
      const bool both = sides_ == Sides::together && mirrors(frame, joint, robot);
      if (both && mirrored(joint) < joint) continue;
      const Link& link = robot.linkMovedBy(joint);
      add({i, Place::What::joint, joint, both}, nameOf(robot, joint, both) + number,
          toDegrees(frame.angles[joint]), toDegrees(link.lower) + limitMargin,
          toDegrees(link.upper) - limitMargin, angleSigma);
    }
  }
}

void MotionParameters::add(const Place& place, const std::string& name, double start, double lower,
                           double upper, double sigma) {
  places_.push_back(place);
  list_.push_back({name, std::clamp(start, lower, upper), lower, upper, sigma});
}

KeyframeMotion MotionParameters::motion(const Eigen::VectorXd& values) const {
  KeyframeMotion result = motion_;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Place& place = places_[i];
    Keyframe& frame = result.keyframes[place.keyframe];
    const double value = values[static_cast<Eigen::Index>(i)];
    switch (place.what) {
      case Place::What::seconds:
        frame.seconds = std::round(value) / 1e3;
        break;
      case Place::What::settle:
        frame.settleSeconds = std::round(value) / 1e3;
        break;
      case Place::What::joint:
        frame.angles[place.joint] = fromDegrees(std::round(10 * value) / 10);
        if (place.both)
          frame.angles[mirrored(place.joint)] = mirrorSign(place.joint) * frame.angles[place.joint];
        break;
    }
  }
  return result;
}

KeyframeMotion MotionParameters::written(const Eigen::VectorXd& values, double cycle) const {
  KeyframeMotion result = motion(values);
  std::vector<Keyframe>& frames = result.keyframes;
  for (std::size_t i = 0; i + 1 < frames.size();)
    if (frames[i].seconds + frames[i].settleSeconds < cycle / 2)
      frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  return result;
}

std::string motionFile(const KeyframeMotion& motion, const RobotModel& robot, const std::string& heading) {
  std::string text = commentLines(heading);
  text += "# Angles in degrees, times in seconds; doc/how-to/add-a-motion.md.\n";
  if (motion.ball != Vec2::Zero() || motion.kick)
    text += fmt::format("ball: [{:.3f}, {:.3f}]\nballReach: [{:.3f}, {:.3f}]\n", motion.ball.x(),
                        motion.ball.y(), motion.ballReach.x(), motion.ballReach.y());
  if (motion.kick)
    text += fmt::format(
        "kick: {{distance: {:.2f}, direction: {:.2f}, contact: {:.3f}, scatter: {:.1f}, spread: {:.2f}, "
        "rise: {:.2f}}}\n",
        motion.kick->distance, toDegrees(motion.kick->direction), motion.kick->contact,
        toDegrees(motion.kick->scatter), motion.kick->spread, motion.kick->rise);
  text += "keyframes:\n";
  for (const Keyframe& frame : motion.keyframes) {
    text += fmt::format("  - {{time: {:.3f}", frame.seconds);
    if (frame.settleSeconds > 0) text += fmt::format(", settle: {:.3f}", frame.settleSeconds);
    int inLine = 0;
    for (int j = 0; j < maxJoints; ++j) {
      const auto joint = static_cast<JointId>(j);
      if (!frame.set[joint]) continue;
      const bool both = mirrors(frame, joint, robot);
      if (both && mirrored(joint) < joint) continue;
      text += inLine++ % 6 == 0 ? ",\n     " : ", ";
      text += fmt::format("{}: {:.1f}", nameOf(robot, joint, both), toDegrees(frame.angles[joint]));
    }
    text += "}\n";
  }
  return text;
}

}  // namespace plumbline::motion
