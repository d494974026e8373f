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

namespace plumbline {

MODULE(BallLocator)
REQUIRES(FrameInfo)
REQUIRES(VisionInfo)
REQUIRES(BallPercept)
REQUIRES(Odometry)
REQUIRES(TorsoPose)
REQUIRES(FKModel)
PROVIDES(LocalBallPos)
END_MODULE

/// Tracks the ball relative to the robot: a Kalman filter in the frame of the odometry (BallFilter).
class BallLocator : public BallLocatorBase {
public:
  void init() override;
  void update(LocalBallPos* theLocalBallPos) override;

private:
  Mat2 perceptCovariance(const Vec2& position) const;
  bool shouldBeInView() const;
  void see(LocalBallPos& ball);

  BallFilter filter_;
  double distanceShare_ = 0, distanceNoise_ = 0, angleNoise_ = 0;  ///< [-], [m], [rad]
  double stepShare_ = 0;      ///< error of the odometry, share of the way
  double touchDistance_ = 0;  ///< nearer than this the robot may touch the ball [m]
  double forgetSeconds_ = 0;  ///< not seen for so long, the ball is lost [s]
  double viewAngle_ = 0;      ///< within it the ball would be seen [rad]
  int missedImages_ = 0;      ///< so often in view but not seen, it is lost
  double lastSeen_ = -1;
  int missed_ = 0;
  bool valid_ = false;
};

}  // namespace plumbline
