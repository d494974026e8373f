#pragma once
#include <map>
#include <string>
#include <vector>

#include "motion/Keyframes.h"
#include "robot/RobotModel.h"

namespace plumbline::motion {

/// A keyframe as a person edits it: seconds, and degrees by the joints' names.
struct KeyframeDraft {
  int from = -1;  ///< index of the file's keyframe that it was; -1: new
  double seconds = 0, settleSeconds = 0;
  std::map<std::string, double> degrees;
};

/// The keyframes of a file's text in the terms of a draft. The text must be one that readKeyframeText takes.
std::vector<KeyframeDraft> draftOf(const KeyframeMotion& motion, const RobotModel& robot);

/// The text of a motion's file with these keyframes: numbers that stay keep their digits, keyframes that stay
/// keep their comments, and both sides stay under one name where they are mirror images. Does not check
/// limits: read the result. Throws KeyframeFileError "path:line: ..." for a text that cannot be edited so, as
/// a motion that is the mirror image of another one.
std::string editedText(const std::string& text, const std::string& path,
                       const std::vector<KeyframeDraft>& keyframes, const RobotModel& robot);

}  // namespace plumbline::motion
