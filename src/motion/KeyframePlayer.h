#pragma once
#include <array>

#include "motion/Keyframes.h"

namespace plumbline::motion {

/// Plays one keyframe motion: call step once per cycle and send angles() to the joints.
class KeyframePlayer {
public:
  /// Begins the motion at these joint angles [rad]. The motion is copied.
  void start(const KeyframeMotion& motion, const JointArray& from);
  /// Advances by seconds; still: the torso does not turn now (ends a wait to settle). After the last keyframe
  /// its angles are held.
  void step(double seconds, bool still);

  bool finished() const { return index_ >= motion_.keyframes.size(); }
  const JointArray& angles() const { return current_; }
  /// The joints the motion has moved so far.
  const JointFlags& joints() const { return touched_; }
  std::size_t keyframe() const { return index_; }

private:
  void enter();

  KeyframeMotion motion_;
  std::size_t index_ = 0;
  double elapsed_ = 0;  ///< since the keyframe's start, settling included [s]
  JointArray begin_{}, current_{};
  JointFlags touched_{};
};

}  // namespace plumbline::motion
