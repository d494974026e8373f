#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "motion/Keyframes.h"
#include "robot/RobotModel.h"

namespace plumbline::motion {

/// What a motion's file may hold at most.
inline constexpr std::size_t maxKeyframes = 1000, maxKeyframeFileBytes = 1 << 20;

/// A keyframe file that cannot be used; what() is one line "file:line: key: what is wrong and what to do".
class KeyframeFileError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A motion that is made for other robots (`robots:` in its file).
class MotionOfOtherRobots : public KeyframeFileError {
public:
  using KeyframeFileError::KeyframeFileError;
};

/// The key of a keyframe that means a left joint and its mirror image alike: LKneePitch's is KneePitch. Empty
/// for a joint without a partner and for names that do not begin with L.
std::string bothSides(const RobotModel& robot, JointId left);

/// Reads one motion from a YAML file (format: doc/how-to/add-a-motion.md); degrees in the file, radians
/// here. A file "mirror: other" is the mirror image of other.yaml, looked for along the same directories.
/// Errors: KeyframeFileError.
KeyframeMotion readKeyframeFile(const std::filesystem::path& file, const RobotModel& robot,
                                const std::vector<std::filesystem::path>& directories);

/// The same from a text; file is its name in errors and for the motion's name.
KeyframeMotion readKeyframeText(const std::string& text, const std::filesystem::path& file,
                                const RobotModel& robot,
                                const std::vector<std::filesystem::path>& directories);

/// The files that readMotions reads, by the motions' names.
std::map<std::string, std::filesystem::path> motionFiles(
    const std::vector<std::filesystem::path>& directories);

/// All motions of these directories by name; where a name appears twice the later directory wins, so a
/// robot type's own directory comes last. A directory that does not exist holds no motion, but the first
/// must exist. Without those of other robots. Errors: KeyframeFileError.
std::vector<KeyframeMotion> readMotions(const std::vector<std::filesystem::path>& directories,
                                        const RobotModel& robot);

}  // namespace plumbline::motion
