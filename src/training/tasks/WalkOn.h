#pragma once
#include "training/MotionDriver.h"

namespace plumbline::training {

/// The walk right after a motion that shows whether the robot can go on: two seconds into a random direction
/// with a random turn (Seekircher 2015, 3.1.1). Or it stands still instead, in a share of the runs.
class WalkOn {
public:
  /// Draws direction, turn and, where `still` is above 0, whether it stands from the driver's generator.
  explicit WalkOn(MotionDriver& driver, double seconds = 2, double still = 0);
  /// Begins at these targets and fades into the walk's [s]; 0: at once. Into the stand it fades as
  /// StandMotion does.
  void begin(const JointArray& from, double fadeSeconds = 0);
  void step();
  bool isOver() const;

  /// Angle between torso and upright, summed over the cycles so far [rad].
  double error() const { return error_; }
  /// The torso leans by less than 30 degrees.
  bool upright() const;

private:
  MotionDriver& driver_;
  double seconds_;
  Vec2 velocity_;
  double turn_;
  bool stands_;
  JointArray from_{};
  double fade_ = 0, error_ = 0;
  int cycles_ = 0;
};

}  // namespace plumbline::training
