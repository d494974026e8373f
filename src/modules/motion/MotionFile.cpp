#include "modules/motion/MotionFile.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "framework/ReadFile.h"
#include "framework/WriteFile.h"
#include "math/Fingerprint.h"
#include "motion/KeyframeReader.h"

namespace plumbline {

namespace fs = std::filesystem;

namespace {

std::string revisionOf(const std::string& text) {
  Fingerprint print;
  for (const char c : text) print.add(static_cast<unsigned char>(c));
  return fmt::format("{:016x}", print.value());
}

/// What cannot be said in the file, or is none of the robot's joints.
void checkNumbers(const std::vector<motion::KeyframeDraft>& keyframes, const std::string& path,
                  const RobotModel& robot) {
  if (keyframes.empty()) throw motion::KeyframeFileError(path + ": a motion has one keyframe at least");
  if (keyframes.size() > motion::maxKeyframes)
    throw motion::KeyframeFileError(path + ": more than " + std::to_string(motion::maxKeyframes) +
                                    " keyframes");
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    const std::string which = path + ": keyframe " + std::to_string(i + 1) + ": ";
    if (!(keyframes[i].seconds >= 0)) throw motion::KeyframeFileError(which + "the time is negative");
    if (!(keyframes[i].settleSeconds >= 0))
      throw motion::KeyframeFileError(which + "the time to settle is negative");
    for (const auto& [joint, degrees] : keyframes[i].degrees) {
      if (!robot.joint(joint)) throw motion::KeyframeFileError(which + "there is no joint \"" + joint + '"');
      if (!std::isfinite(degrees)) throw motion::KeyframeFileError(which + joint + " is not finite");
    }
  }
}

}  // namespace

std::string MotionFile::text() const {
  try {
    return readFile(file_, motion::maxKeyframeFileBytes);
  } catch (const FileProblem& problem) {
    throw std::runtime_error(file_.string() + ": " + problem.what());
  }
}

MotionDraft MotionFile::read(const RobotModel& robot) const {
  MotionDraft draft;
  draft.file = file_.string();
  try {
    const std::string now = text();
    draft.revision = revisionOf(now);
    const motion::KeyframeMotion motion = motion::readKeyframeText(now, file_, robot, directories_);
    const std::vector<motion::KeyframeDraft> keyframes = motion::draftOf(motion, robot);
    draft.keyframes = streamed(keyframes);
    draft.restStays = now.find("rest:") != std::string::npos;
    motion::editedText(now, draft.file, keyframes, robot);
  } catch (const std::exception& error) {
    draft.comment = error.what();
  }
  return draft;
}

std::string MotionFile::edited(const MotionDraft& draft, const std::string& text, const RobotModel& robot,
                               motion::KeyframeMotion* motion) const {
  const std::vector<motion::KeyframeDraft> keyframes = wanted(draft.keyframes);
  checkNumbers(keyframes, file_.string(), robot);
  std::string result = motion::editedText(text, file_.string(), keyframes, robot);
  motion::KeyframeMotion read = motion::readKeyframeText(result, file_, robot, directories_);
  // What is written must be what was asked for, whatever form the file has.
  const std::vector<motion::KeyframeDraft> there = motion::draftOf(read, robot);
  constexpr double rounding = 1e-3;  // three decimals are written
  bool same = there.size() == keyframes.size();
  for (std::size_t i = 0; same && i < there.size(); ++i) {
    same = std::fabs(there[i].seconds - keyframes[i].seconds) < rounding &&
           std::fabs(there[i].settleSeconds - keyframes[i].settleSeconds) < rounding &&
           there[i].degrees.size() == keyframes[i].degrees.size();
    for (const auto& [joint, degrees] : keyframes[i].degrees) {
      const auto found = there[i].degrees.find(joint);
      same = same && found != there[i].degrees.end() && std::fabs(found->second - degrees) < rounding;
    }
  }
  if (!same)
    throw motion::KeyframeFileError(file_.string() +
                                    ": the layout of this file does not allow this change; edit it by hand");
  if (motion) *motion = std::move(read);
  return result;
}

motion::KeyframeMotion MotionFile::check(const MotionDraft& draft, const RobotModel& robot) const {
  motion::KeyframeMotion motion;
  edited(draft, text(), robot, &motion);
  return motion;
}

bool MotionFile::write(const MotionDraft& draft, const RobotModel& robot) const {
  const std::string now = text();
  if (revisionOf(now) != draft.revision)
    throw std::runtime_error(file_.string() + " was changed by somebody else; nothing is written");
  const std::string result = edited(draft, now, robot, nullptr);
  if (result == now) return false;
  writeFile(fs::canonical(file_).string(), result);
  return true;
}

}  // namespace plumbline
