#pragma once
#include <list>
#include <memory>
#include <string>

#include "framework/AgentDebug.h"
#include "framework/Module.h"
#include "modules/motion/EditedMotion.h"
#include "modules/motion/MotionFile.h"
#include "representations/infrastructure/RobotDescription.h"

namespace plumbline {

MODULE(MotionEditor)
  REQUIRES(RobotDescription)
END_MODULE

/// The files of keyframe motions in the debug interface, for a page that edits them: `motion:NAME` is the
/// file of a motion, and setting it or a part of it writes the file. `module:MotionEditor:draft` is what is
/// played under the name EditedMotion::name without being written. An impossible motion is refused, and
/// nothing changes. `module:MotionEditor:robot` has the joints with their limits and the links;
/// `module:MotionEditor:opened` is the motion of the command line.
class MotionEditor : public MotionEditorBase {
public:
  ~MotionEditor() override;
  void init() override;
  void execute() override;

  /// What shall be played: keyframes first to last, from the posture that comes before.
  struct Draft {
    std::string motion;  ///< name of the file that the keyframes are of
    unsigned first = 0, last = 0;
    std::vector<DraftKeyframe> keyframes;
    void stream(InStream* in, OutStream* out) {
      STREAM(motion);
      STREAM(first);
      STREAM(last);
      STREAM(keyframes);
    }
  };

private:
  friend class MotionFileValue;
  friend class MotionDraftValue;
  struct Entry {
    Entry(const std::string& name, MotionFile of)
        : id("motion:" + name), point(id.c_str(), DebugKind::parameter), file(std::move(of)) {}
    std::string id;
    DebugPoint point;
    MotionFile file;
  };

  const RobotModel& robot() const { return theRobotDescription->model; }
  /// Throws what MotionFile::check throws.
  void take(const Draft& draft);

  AgentDebug* agent_ = nullptr;
  std::list<Entry> files_;
  DebugPoint draftPoint_{"module:MotionEditor:draft", DebugKind::parameter};
  Draft draft_;
  EditedMotion* edited_ = nullptr;
  std::string opened_;
};

}  // namespace plumbline
