#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "math/Pose2.h"
#include "parameters/Parameter.h"

namespace plumbline {

/// The fastest walk in each direction alone. Mixtures are walked so that the shares sum up to 1 at most.
struct WalkSpeeds {
  double forward = 0.5, backward = 0.4, sideways = 0.25;  ///< [m/s]
  double turn = 1.6;                                      ///< [rad/s]
};

struct ApproachMapParameters {
  PARAMETERS(ApproachMapParameters)
  PARAMETER(double, reach, 1.6, "m", Range(0.5, 5), "half the side of the square that the map covers")
  PARAMETER(int, cells, 16, "", Range(4, 64), "of its grid, in half a side")
  PARAMETER(int, headings, 24, "", Range(8, 90), "of its grid, all round")
  PARAMETER(double, front, 0.15, "m", Range(0, 1), "a ball nearer than this before the robot is touched")
  PARAMETER(double, side, 0.2, "m", Range(0, 1), "the same beside it")
  PARAMETER(double, back, 0.17, "m", Range(0, 1), "the same behind it")
  PARAMETER(double, touchPrice, 8, "", Range(1, 100), "how many times as long a walk counts that touches it")
  PARAMETER(double, farSpeed, 0.8, "m/s", Range(0.05, 3), "of a robot on its way to the map")
};

/// The least time in which a robot that walks with given speeds gets to a place at the ball without touching
/// the ball, from every pose around it: the solution of the walk's Bellman equation on a grid. Poses are
/// given in the frame of the place [m, rad]; `ball`: where it lies there.
class ApproachMap {
public:
  ApproachMap(const WalkSpeeds& speeds, const Vec2& ball, const ApproachMapParameters& parameters);

  /// [s]; beyond the map, with a straight way to its border.
  double seconds(const Pose2& pose) const;
  bool covers(const Vec2& position) const { return position.cwiseAbs().maxCoeff() <= parameters_.reach; }
  /// Whether a robot at that pose touches the ball.
  bool touches(const Pose2& pose) const;
  /// How many times as long as it is a walk counts at that pose.
  double price(const Pose2& pose) const { return touches(pose) ? parameters_.touchPrice : 1; }
  const WalkSpeeds& speeds() const { return speeds_; }

private:
  struct Step;
  std::vector<Step> stepsFrom(int heading) const;
  Pose2 node(int ix, int iy, int heading) const;
  std::size_t index(int ix, int iy, int heading) const;
  double inside(const Pose2& pose) const;
  void solve();

  WalkSpeeds speeds_;
  Vec2 ball_;
  ApproachMapParameters parameters_;
  int side_ = 0;  ///< nodes in a side
  double cell_ = 0, turnCell_ = 0;
  std::vector<float> seconds_;
};

}  // namespace plumbline
