#pragma once
#include "framework/Module.h"
#include "modules/modeling/ball/BallFilter.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/FKModel.h"
#include "representations/modeling/Odometry.h"
#include "representations/modeling/TorsoPose.h"
#include "representations/perception/BallPercept.h"
#include "representations/perception/PolarPercepts.h"
#include "representations/perception/SureView.h"

namespace plumbline {

MODULE(BallLocator)
  REQUIRES(FrameInfo)
  REQUIRES(VisionInfo)
  REQUIRES(BallPercept)
  REQUIRES(Odometry)
  REQUIRES(TorsoPose)
  REQUIRES(FKModel)
  PROVIDES(LocalBallPos)
  PARAMETER_GROUP(BallFilter::Parameters, filter, "the Kalman filter")
  PARAMETER(double, distanceShare, 0.001, "", Range(0, 1),
            "standard deviation of a percept along the line of sight, share of the distance")
  PARAMETER(double, distanceNoise, 0.004, "m", Range(1e-6, 1),
            "standard deviation of a percept at no distance")
  PARAMETER(double, angleNoise, 0.0026, "rad", Range(1e-6, 1),
            "standard deviation of a percept across the line of sight")
  PARAMETER(double, stepShare, odometryErrorShare, "", Range(0, 1),
            "error of the odometry, share of the distance walked")
  PARAMETER(double, touchDistance, 0.4, "m", Range(0, 10), "the robot may touch a ball that is nearer")
  PARAMETER(double, forgetSeconds, 10, "s", Range(0, 1e4), "time after which an unseen ball is lost")
  PARAMETER(double, viewAngle, sureViewAngle, "rad", Range(0, 1.5),
            "the ball would be seen within this angle of the axis of the head")
  PARAMETER(int, missedImages, 4, "", Range(1, 10000),
            "number of images without a ball that should be in view after which it is lost")
END_MODULE

/// Tracks the ball relative to the robot: a Kalman filter in the frame of the odometry (BallFilter).
class BallLocator : public BallLocatorBase {
public:
  void parametersChanged() override;
  void update(LocalBallPos* theLocalBallPos) override;

private:
  Mat2 perceptCovariance(const Vec2& position) const;
  bool shouldBeInView() const;
  void see(LocalBallPos& ball);

  BallFilter filter_;
  double lastSeen_ = -1;
  int missed_ = 0;
  bool valid_ = false;
};

}  // namespace plumbline
