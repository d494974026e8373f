#pragma once
#include "training/MotionDriver.h"
#include "trials/AfterMotion.h"

namespace plumbline::training {

/// What shows whether the robot can go on after a motion (AfterMotion), for two seconds or as long as said.
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
  bool upright() const { return AfterMotion::upright(driver_.tilt()); }

private:
  MotionDriver& driver_;
  double seconds_;
  AfterMotion after_;
  JointArray from_{};
  double fade_ = 0, error_ = 0;
  int cycles_ = 0;
};

}  // namespace plumbline::training
