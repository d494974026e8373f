#pragma once
#include "framework/Module.h"
#include "math/Random.h"
#include "representations/infrastructure/JointData.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/modeling/FallState.h"
#include "representations/motion/MotionSelection.h"
#include "representations/optimization/FallOverOutput.h"
#include "representations/optimization/OptimizationTrial.h"

namespace plumbline {

MODULE(FallOver)
  REQUIRES(RobotDescription)
  REQUIRES(OptimizationTrial)
  REQUIRES(MotionSelection)
  REQUIRES(JointData)
  REQUIRES(FallState)
  PROVIDES(FallOverOutput)
  PARAMETER(double, leastLean, 0.4, "rad", Range(0, 1), "of the ankles, by which a standing robot falls")
  PARAMETER(double, mostLean, 0.7, "rad", Range(0, 1), "the same, at most")
  PARAMETER(double, spread, 0.25, "rad", Range(0, 1),
            "largest difference of each joint from the stand while it falls")
END_MODULE

/// Throws a standing robot over for a try of the task standUp, forward or backward: it leans at its ankles,
/// and while it falls its joints go anywhere near the stand. The trial's seed says how; each time that the
/// motion begins again it falls in another way.
class FallOver : public FallOverBase {
public:
  void parametersChanged() override;
  void update(FallOverOutput* theFallOverOutput) override;

private:
  void draw();

  std::int64_t number_ = -1;
  Random random_{0};
  JointArray leaning_{}, falling_{};
};

}  // namespace plumbline
