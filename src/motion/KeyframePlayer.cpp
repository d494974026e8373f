#include "motion/KeyframePlayer.h"

#include <algorithm>

namespace plumbline::motion {

namespace {
// Cycle times add up to a keyframe's time only up to rounding; a cycle must not be lost to that.
constexpr double rounding = 1e-9;
}  // namespace

void KeyframePlayer::start(const KeyframeMotion& motion, const JointArray& from) {
  motion_ = motion;
  index_ = 0;
  elapsed_ = 0;
  current_ = from;
  touched_.fill(false);
  enter();
}

void KeyframePlayer::enter() {
  begin_ = current_;
  if (finished()) return;
  for (int j = 0; j < maxJoints; ++j) touched_[j] = touched_[j] || motion_.keyframes[index_].set[j];
}

void KeyframePlayer::step(double seconds, bool still) {
  elapsed_ += seconds;
  while (!finished()) {
    const Keyframe& frame = motion_.keyframes[index_];
    const double ratio = elapsed_ + rounding >= frame.seconds ? 1 : elapsed_ / frame.seconds;
    for (int j = 0; j < maxJoints; ++j)
      if (frame.set[j]) current_[j] = begin_[j] + ratio * (frame.angles[j] - begin_[j]);
    if (ratio < 1) return;
    const bool settled = still || elapsed_ + rounding >= frame.seconds + frame.settleSeconds;
    if (frame.settleSeconds > 0 && !settled) return;
    // The rest of a cycle after a keyframe belongs to the next keyframe, except after a wait.
    const double left = std::max(0.0, elapsed_ - frame.seconds);
    elapsed_ = frame.settleSeconds > 0 ? 0 : left;
    ++index_;
    enter();
    if (elapsed_ < rounding) return;
  }
}

}  // namespace plumbline::motion
