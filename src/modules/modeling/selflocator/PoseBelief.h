#pragma once
#include "math/Pose2.h"
#include "modules/modeling/selflocator/FieldMap.h"
#include "modules/modeling/selflocator/FieldView.h"

namespace plumbline {

/// One Gaussian belief of where the robot is: T_field_robot and the covariance of a small motion
/// (forward, left [m], turn [rad]) in the robot's own frame.
struct PoseBelief {
  Pose2 pose;
  Mat3 covariance = Mat3::Identity();
};

/// The robot moved by step (T_before_now); noise: deviations of the step (forward, left, turn). Moves any
/// number of beliefs.
class PoseStep {
public:
  PoseStep(const Pose2& step, const Vec3& noise);
  void apply(PoseBelief& belief) const;

private:
  Pose2 step_;
  Mat3 transition_ = Mat3::Identity();
  Vec3 variance_;
};

/// How well an image fits a belief.
struct Fit {
  double error = 0;      ///< squared Mahalanobis distance of all that was matched, prior included
  int measurements = 0;  ///< scalars that were matched
  int matchedLines = 0;
};

/// Gauss-Newton update of a belief by an image: landmarks by their names, then lines matched to the nearest
/// segments of the map that can only be meant. The error is the joint one of all innovations.
class PoseUpdate {
public:
  PoseUpdate(const FieldMap& map, const FieldView& view) : map_(map), view_(view) {}

  /// Changes the belief in place.
  Fit apply(PoseBelief& belief) const;

private:
  struct Normal;
  /// back: the inverse of the pose's rotation.
  void addLandmarks(const Pose2& pose, const Mat2& back, Normal& sum) const;
  void addLines(const PoseBelief& belief, const Mat2& back, Normal& sum, Fit& fit) const;

  const FieldMap& map_;
  const FieldView& view_;
};

}  // namespace plumbline
