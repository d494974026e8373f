#pragma once
#include <optional>
#include <string>

#include "framework/Module.h"
#include "modules/modeling/ground/TorsoHeight.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/modeling/FKModel.h"
#include "representations/modeling/GroundContactState.h"
#include "representations/modeling/TorsoAngles.h"
#include "representations/modeling/TorsoPose.h"

namespace plumbline {

MODULE(TorsoPoseProvider)
  REQUIRES(FrameInfo)
  REQUIRES(RobotDescription)
  REQUIRES(FKModel)
  REQUIRES(TorsoAngles)
  REQUIRES(UprightVec)
  REQUIRES(GroundContactState)
  PROVIDES(TorsoPose)
  PARAMETER(double, lyingTilt, 0.9, "rad", Range(0, 3.2),
            "tilted more, the lowest point of the body touches the ground, not the feet")
  PARAMETER(double, contactMemory, 0.3, "s", Range(0, 10),
            "time without load on the feet for which the robot still counts as standing")
END_MODULE

/// Tilt and height of the torso over the ground: the lowest point of the feet touches it, or, when the robot
/// lies, the lowest point of its body.
class TorsoPoseProvider : public TorsoPoseProviderBase {
public:
  void update(TorsoPose* theTorsoPose) override;

private:
  std::string robot_;
  std::optional<TorsoHeight> height_;
  double withoutContact_ = 0;  ///< [s]
};

}  // namespace plumbline
