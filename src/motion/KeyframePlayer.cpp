#include "motion/KeyframePlayer.h"

#include <algorithm>

namespace plumbline::motion {

namespace {
// Cycle times add up to a keyframe's time only up to rounding; a cycle must not be lost to that.
constexpr double rounding = 1e-9;
}  // namespace

void KeyframePlayer::start(const KeyframeMotion& motion_, const JointArray& from) {
  motion = motion_;
  index = 0;
  elapsed = 0;
  current = from;
  touched.fill(false);
  enter();
}

void KeyframePlayer::enter() {
  begin = current;
  if (finished()) return;
  for (int j = 0; j < maxJoints; ++j) touched[j] = touched[j] || motion.keyframes[index].set[j];
}

void KeyframePlayer::step(double seconds, bool still) {
  elapsed += seconds;
  while (!finished()) {
    const Keyframe& frame = motion.keyframes[index];
    const double ratio = elapsed + rounding >= frame.seconds ? 1 : elapsed / frame.seconds;
    for (int j = 0; j < maxJoints; ++j)
      if (frame.set[j]) current[j] = begin[j] + ratio * (frame.angles[j] - begin[j]);
    if (ratio < 1) return;
    const bool settled = still || elapsed + rounding >= frame.seconds + frame.settleSeconds;
    if (frame.settleSeconds > 0 && !settled) return;
    // What a keyframe has left over of the cycle belongs to the next one, except after a wait.
    const double left = std::max(0.0, elapsed - frame.seconds);
    elapsed = frame.settleSeconds > 0 ? 0 : left;
    ++index;
    enter();
    if (elapsed < rounding) return;
  }
}

}  // namespace plumbline::motion
