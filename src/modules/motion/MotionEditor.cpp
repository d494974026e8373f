#include "modules/motion/MotionEditor.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "framework/DebugSite.h"
#include "math/Angle.h"
#include "modules/motion/MotionToPlay.h"
#include "motion/KeyframeReader.h"

namespace plumbline {

MAKE_MODULE(MotionEditor)
MAKE_MODULE_OBJECT(EditedMotion, EditedMotion)

namespace {

constexpr double approachSeconds = 0.8;  // to the posture before the first keyframe that is played [s]

/// A link and the hinge to its parent, for who draws the robot and moves its joints.
struct RobotPart {
  std::string name, joint, otherSide;  ///< otherSide: the mirror image's joint, if it is another one
  int parent = -1, number = -1;        ///< number: of the joint in JointData::angles
  double mirrorSign = 1;
  double lower = 0, upper = 0, speed = 0;  ///< [degrees, degrees/s]
  Vec3 origin = Vec3::Zero(), axis = Vec3::UnitZ(), com = Vec3::Zero();
  std::string shape;
  Vec3 size = Vec3::Zero();
  Pose3 T_link_shape = Pose3::Identity();
  void stream(InStream* in, OutStream* out) {
    STREAM(name);
    STREAM(joint);
    STREAM(otherSide);
    STREAM(parent);
    STREAM(number);
    STREAM(mirrorSign);
    STREAM(lower);
    STREAM(upper);
    STREAM(speed);
    STREAM(origin);
    STREAM(axis);
    STREAM(com);
    STREAM(shape);
    STREAM(size);
    STREAM(T_link_shape);
  }
};

std::vector<RobotPart> partsOf(const RobotModel& robot) {
  std::vector<RobotPart> parts;
  for (const Link& link : robot.links) {
    RobotPart part;
    part.name = link.name;
    part.parent = link.parent;
    if (link.joint != noJoint) {
      part.number = link.joint;
      const JointId other = motion::mirrored(link.joint);
      part.joint = robot.jointName(link.joint);
      if (other != link.joint && robot.has(other)) part.otherSide = robot.jointName(other);
      part.mirrorSign = motion::mirrorSign(link.joint);
      part.lower = toDegrees(link.lower);
      part.upper = toDegrees(link.upper);
      part.speed = toDegrees(link.maxSpeed);
    }
    part.origin = link.origin;
    part.axis = link.axis;
    part.com = link.com;
    part.size = link.shape.size;
    part.T_link_shape = link.shape.T_link_shape;
    part.shape = link.shape.kind == Shape::Kind::box      ? "box"
                 : link.shape.kind == Shape::Kind::sphere ? "sphere"
                                                          : "capsule";
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace

/// Reading it reads the file, setting it writes the file.
class MotionFileValue final : public DebugValue {
public:
  MotionFileValue(MotionEditor& editor, const MotionFile& file) : editor_(editor), file_(file) {}
  void write(OutStream& out) const override {
    StreamType<MotionDraft>::write(out, file_.read(editor_.robot()));
  }
  bool writable() const override { return true; }
  void read(InStream& in) override {
    MotionDraft draft;
    StreamType<MotionDraft>::read(in, draft);
    if (!in.ok()) return;
    try {
      if (file_.write(draft, editor_.robot())) editor_.edited_->save();
    } catch (const std::exception& error) {
      in.fail(error.what());
    }
  }

private:
  MotionEditor& editor_;
  const MotionFile& file_;
};

class MotionDraftValue final : public DebugValue {
public:
  explicit MotionDraftValue(MotionEditor& editor) : editor_(editor) {}
  void write(OutStream& out) const override { StreamType<MotionEditor::Draft>::write(out, editor_.draft_); }
  bool writable() const override { return true; }
  void read(InStream& in) override {
    MotionEditor::Draft draft;
    StreamType<MotionEditor::Draft>::read(in, draft);
    if (!in.ok()) return;
    try {
      editor_.take(draft);
    } catch (const std::exception& error) {
      in.fail(error.what());
    }
  }

private:
  MotionEditor& editor_;
};

void MotionEditor::init() {
  agent_ = findObject<AgentDebug>();
  edited_ = &object<EditedMotion>();
  if (const auto* wanted = findObject<MotionToPlay>()) opened_ = wanted->name;
  if (!agent_) return;
  std::vector<std::filesystem::path> directories;
  for (const std::string& directory : config.directories())
    directories.push_back(std::filesystem::path(directory) / "motions");
  for (const auto& [name, file] : motion::motionFiles(directories)) {
    Entry& entry = files_.emplace_back(name, MotionFile(file, directories));
    agent_->points.add(entry.point);
  }
  agent_->points.add(draftPoint_);
}

MotionEditor::~MotionEditor() {
  if (!agent_) return;
  for (Entry& entry : files_) agent_->points.remove(entry.point);
  agent_->points.remove(draftPoint_);
}

void MotionEditor::take(const Draft& draft) {
  if (draft.motion.empty() && draft.keyframes.empty()) {
    draft_ = draft;
    return edited_->setDraft({});
  }
  const auto entry =
      std::ranges::find_if(files_, [&](const Entry& e) { return e.id == "motion:" + draft.motion; });
  if (entry == files_.end()) throw std::runtime_error("there is no motion " + draft.motion);
  if (draft.first > draft.last || draft.last >= draft.keyframes.size())
    throw std::runtime_error("first and last must be keyframes of the draft");
  motion::KeyframeMotion motion = entry->file.check({{}, {}, {}, false, draft.keyframes}, robot());
  motion::Keyframe posture;
  posture.seconds = approachSeconds;
  for (std::size_t i = 0; i < draft.first; ++i)
    for (std::size_t j = 0; j < posture.set.size(); ++j)
      if (motion.keyframes[i].set[j]) {
        posture.set[j] = true;
        posture.angles[j] = motion.keyframes[i].angles[j];
      }
  motion.keyframes.resize(draft.last + 1);
  motion.keyframes.erase(motion.keyframes.begin(), motion.keyframes.begin() + draft.first);
  if (draft.first > 0) motion.keyframes.insert(motion.keyframes.begin(), posture);
  motion.name = EditedMotion::name;
  draft_ = draft;
  edited_->setDraft(std::move(motion));
}

void MotionEditor::execute() {
  if (!agent_ || !theRobotDescription->known()) return;
  for (Entry& entry : files_) {
    if (!entry.point.active()) continue;
    MotionFileValue value(*this, entry.file);
    entry.point.pass(value);
  }
  if (draftPoint_.active()) {
    MotionDraftValue value(*this);
    draftPoint_.pass(value);
  }
  OUTPUT_BY_VALUE("module:MotionEditor:robot", partsOf(robot()));
  OUTPUT("module:MotionEditor:opened", opened_);
}

}  // namespace plumbline
