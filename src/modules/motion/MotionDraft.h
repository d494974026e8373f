#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "framework/Streamable.h"
#include "motion/KeyframeText.h"

namespace plumbline {

/// An angle of a keyframe, as it streams.
struct DraftAngle {
  std::string joint;
  double degrees = 0;
  void stream(InStream* in, OutStream* out) {
    STREAM(joint);
    STREAM(degrees);
  }
};

/// A keyframe, as it streams: see motion::KeyframeDraft.
struct DraftKeyframe {
  int from = -1;
  double time = 0, settle = 0;
  std::vector<DraftAngle> joints;
  void stream(InStream* in, OutStream* out) {
    STREAM(from);
    STREAM(time);
    STREAM(settle);
    STREAM(joints);
  }
};

/// A motion's file in the debug interface.
struct MotionDraft {
  std::string file;        ///< path
  std::string revision;    ///< of the text that it was read from
  std::string comment;     ///< why it cannot be edited; empty: it can
  bool restStays = false;  ///< a keyframe may leave joints out
  std::vector<DraftKeyframe> keyframes;
  void stream(InStream* in, OutStream* out) {
    STREAM(file);
    STREAM(revision);
    STREAM(comment);
    STREAM(restStays);
    STREAM(keyframes);
  }
};

inline std::vector<DraftKeyframe> streamed(const std::vector<motion::KeyframeDraft>& keyframes) {
  std::vector<DraftKeyframe> result;
  for (const motion::KeyframeDraft& keyframe : keyframes) {
    result.push_back({keyframe.from, keyframe.seconds, keyframe.settleSeconds, {}});
    for (const auto& [joint, degrees] : keyframe.degrees) result.back().joints.push_back({joint, degrees});
  }
  return result;
}

inline std::vector<motion::KeyframeDraft> wanted(const std::vector<DraftKeyframe>& keyframes) {
  std::vector<motion::KeyframeDraft> result;
  for (const DraftKeyframe& keyframe : keyframes) {
    result.push_back({keyframe.from, keyframe.time, keyframe.settle, {}});
    for (const DraftAngle& angle : keyframe.joints) result.back().degrees[angle.joint] = angle.degrees;
  }
  return result;
}

}  // namespace plumbline
