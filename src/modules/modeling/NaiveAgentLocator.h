#pragma once
#include <vector>

#include "framework/Module.h"
#include "modules/modeling/others/BodyView.h"
#include "modules/modeling/others/RobotTrack.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/PlayerInfo.h"
#include "representations/modeling/FKModel.h"
#include "representations/modeling/OtherRobots.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/TorsoPose.h"
#include "representations/perception/PolarPercepts.h"
#include "representations/perception/SureView.h"

namespace plumbline {

MODULE(NaiveAgentLocator)
  REQUIRES(FrameInfo)
  REQUIRES(PlayerInfo)
  REQUIRES(VisionInfo)
  REQUIRES(PolarPlayerPercept)
  REQUIRES(TorsoPose)
  REQUIRES(FKModel)
  REQUIRES(RobotPose)
  PROVIDES(LocalOtherRobots)
  PARAMETER_GROUP(BodyViewParameters, body, "a robot's place from its visible parts")
  PARAMETER_GROUP(RobotTrack::Parameters, track, "the Kalman filter of each robot")
  PARAMETER(double, headingNoise, 0.02, "rad", Range(0, 1),
            "error of the own heading, by which far robots are misplaced")
  PARAMETER(double, forgetSeconds, 12, "s", Range(0.1, 1e4), "a robot unseen for longer is forgotten")
  PARAMETER(double, viewAngle, sureViewAngle, "rad", Range(0, 1.5),
            "a robot would be seen within this angle of the axis of the head")
  PARAMETER(double, coverAngle, 0.15, "rad", Range(0, 1),
            "a nearer robot that is closer to the same direction may hide it")
  PARAMETER(
      int, missedImages, 12, "", Range(1, 10000),
      "images without a robot that should be in view and is hidden by none, after which it is forgotten")
END_MODULE

/// Follows the other robots from their visible parts (Seekircher 2015, A.3), also while they are hidden; each
/// has a covariance that grows until it is seen again. Robots whose number cannot be read are taken for the
/// nearest one of their team. The field's frame holds them because the self-localisation does not drift.
class NaiveAgentLocator : public NaiveAgentLocatorBase {
public:
  void update(LocalOtherRobots* theLocalOtherRobots) override;

private:
  void see(const Pose3& T_ground_head);
  RobotTrack* trackOf(bool mate, int number, const Vec2& position);
  void miss(const Pose3& T_ground_head);
  bool shouldBeInView(const RobotTrack& track, const Pose3& T_head_ground) const;
  bool hidden(const RobotTrack& track) const;

  std::vector<RobotTrack> tracks_;
};

}  // namespace plumbline
