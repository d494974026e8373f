#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "training/MotionTrial.h"

namespace plumbline::motion {
using training::MotionTrial;

constexpr double longestStandUp = 12;  ///< repeats included [s]

struct StandUpResult {
  bool up = false;
  LyingOn lay = LyingOn::front;  ///< before the first try
  int tries = 0;                 ///< without those that roll it off its side
  double seconds = 0;            ///< from lying to up for good, repeats and what is between them included
  bool walked = false;           ///< walked on at once for two seconds
};

/// How a trial's robot comes to lie: MotionTrial::fall or stumble.
enum class Falls { dropped, pushed };

/// Falls and stands up as the agent does, repeating it for up to longestStandUp; then walks in some
/// direction. Nothing if the robot did not fall.
inline std::optional<StandUpResult> standUpTrial(MotionTrial& trial, int direction, unsigned seed,
                                                 Falls falls = Falls::dropped) {
  trial.seed(seed);
  if (!(falls == Falls::pushed ? trial.stumble(direction) : trial.fall(direction))) return std::nullopt;
  StandUpResult result;
  result.lay = lyingOn(trial.up());
  trial.elapsed = 0;
  trial.standUpChoice.forget();
  bool again = false;
  while (!result.up && trial.elapsed < longestStandUp) {
    trial.play(trial.nextStandUp(again));
    again = true;
    if (trial.standUpChoice.rolled()) continue;
    ++result.tries;
    result.seconds = trial.elapsed;
    // The torso may still swing up, and falling over again belongs to the try.
    result.seconds += trial.standStill(trial.standUp.graceSeconds);
    result.up = trial.upright() && trial.height() > 0.85 * trial.standingHeight;
  }
  if (!result.up) return result;
  const double angle = trial.random(-pi, pi);
  result.walked = trial.walkFor(2, 0.15 * Vec2(std::cos(angle), std::sin(angle)), trial.random(-0.5, 0.5));
  return result;
}

struct KickResult {
  double distance = 0;  ///< forward [m]
  double angle = 0;     ///< [rad]
  double seconds = 0;   ///< of the kick
  bool fell = false;
};

/// Kicks a ball that lies within `tolerance` [m] of where the kick expects it; the robot sways a little, as
/// after a stop of the walk.
inline KickResult kickTrial(MotionTrial& trial, Side foot, double tolerance, unsigned seed,
                            const std::string& name = "kickRight") {
  trial.seed(seed);
  trial.robot.restart(Pose2(), trial.stand);
  trial.restarted();
  JointArray sway = trial.stand;
  const double roll = trial.random(-0.035, 0.035), pitch = trial.random(-0.035, 0.035);
  for (const JointId joint : {lHipRoll, rHipRoll}) sway[joint] += roll;
  for (const JointId joint : {lAnkleRoll, rAnkleRoll}) sway[joint] -= roll;
  for (const JointId joint : {lAnklePitch, rAnklePitch}) sway[joint] += pitch;
  for (int i = 0; i < 5; ++i) trial.step(sway);
  const int rest = 3 + static_cast<int>(trial.random(0, 8));
  for (int i = 0; i < rest; ++i) trial.step(trial.stand);

  const KeyframeMotion right = trial.motion(name);
  const KeyframeMotion kick = foot == Side::right ? right : mirrored(right);
  const Pose3 torso = trial.robot.torso().pose;
  const Pose2 ground(torso.translation().x(), torso.translation().y(),
                     std::atan2(torso.linear()(1, 0), torso.linear()(0, 0)));
  const Vec2 ball =
      kick.ball + Vec2(trial.random(-tolerance, tolerance), trial.random(-tolerance, tolerance));
  const Vec2 place = ground * ball;
  simulation::World& world = trial.robot.world();
  world.setBall(Vec3(place.x(), place.y(), 0.042), Vec3::Zero());
  KickResult result;
  trial.elapsed = 0;
  result.fell = !trial.play(shiftedToBall(kick, ball), true);
  result.seconds = trial.elapsed;
  trial.standStill(2);
  result.fell = result.fell || trial.tilt() > 0.5;
  for (int i = 0; i < 500 && world.ball().linearVelocity.norm() > 0.08; ++i) trial.step(trial.stand);
  const Vec2 way = ground.inverse() * Vec2(world.ball().pose.translation().head<2>()) - ball;
  result.distance = way.x();
  result.angle = way.norm() > 0.05 ? std::atan2(way.y(), way.x()) : 0;
  return result;
}

}  // namespace plumbline::motion
