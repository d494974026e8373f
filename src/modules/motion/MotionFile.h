#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "modules/motion/MotionDraft.h"
#include "robot/RobotModel.h"

namespace plumbline {

/// A motion's file that is read and written by an editor.
class MotionFile {
public:
  MotionFile(std::filesystem::path file, std::vector<std::filesystem::path> directories)
      : file_(std::move(file)), directories_(std::move(directories)) {}

  /// As it is on the disk now; one that cannot be edited says why in `comment`.
  MotionDraft read(const RobotModel& robot) const;
  /// The motion that the draft would be. Throws motion::KeyframeFileError for an impossible one.
  motion::KeyframeMotion check(const MotionDraft& draft, const RobotModel& robot) const;
  /// Writes it beside its place, syncs and renames. False: there was nothing to change. Throws what check
  /// throws, std::runtime_error where the file is no longer of the draft's revision or cannot be written.
  bool write(const MotionDraft& draft, const RobotModel& robot) const;

private:
  std::string text() const;
  std::string edited(const MotionDraft& draft, const std::string& text, const RobotModel& robot,
                     motion::KeyframeMotion* motion) const;

  std::filesystem::path file_;
  std::vector<std::filesystem::path> directories_;
};

}  // namespace plumbline
