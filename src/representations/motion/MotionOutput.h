#pragma once
#include <string>

#include "framework/Representation.h"
#include "representations/motion/JointRequest.h"
#include "representations/motion/Motion.h"

namespace plumbline {

/// What a motion provides. A new motion is a module that provides a representation of this kind, and a line
/// in modules.cfg:
///
///     REPRESENTATION_OF(BowOutput, MotionOutput)
///     class BowOutput : public BowOutputBase {
///     public:
///       BowOutput() : BowOutputBase("bow") {}
///     };
///
/// It moves the robot while MotionSelection names it; what its targets do not set is left to the motion
/// before it.
class MotionOutput : public Representation {
public:
  static constexpr const char* kindName() { return "MotionOutput"; }

  std::string motion;         ///< name by which MotionRequest asks for it; never changes
  std::string doing;          ///< for people: "kicking"; never changes
  bool goes = false;          ///< it carries the robot to other places; never changes
  JointTargets targets;       ///< in every cycle, also while it is not selected
  bool finished = true;       ///< another motion may take over now
  bool endsByItself = false;  ///< once finished it restarts if it is still requested
  double fadeSeconds = 0;     ///< to fade into it; 0: it begins at the measured angles [s]
  void stream(InStream* in, OutStream* out) override {
    STREAM(motion);
    STREAM(targets);
    STREAM(finished);
    STREAM(endsByItself);
    STREAM(fadeSeconds);
  }

protected:
  /// Without words for people its name does.
  explicit MotionOutput(const std::string& name, bool ends = false, const std::string& words = {})
      : motion(name), doing(words.empty() ? name : words), endsByItself(ends) {}
  ~MotionOutput() = default;
};

}  // namespace plumbline
