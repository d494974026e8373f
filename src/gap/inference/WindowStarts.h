#pragma once
#include <Eigen/Core>
#include <vector>

#include "gap/replay/Trial.h"

namespace plumbline::gap {

/// A joint's state as its measured positions show it: a parabola fitted to those within 30 ms. Its covariance
/// is that of the fit and, where the motion is no parabola, what a cubic would change.
struct MeasuredState {
  double position = 0, speed = 0;  ///< [rad, rad/s]; NaN next to gaps
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

/// At a cycle's time. noise: least standard deviation of a reading [rad].
MeasuredState stateAt(const Trial& trial, const Signal& position, std::size_t cycle, double noise);

/// A stretch of a trial that is replayed from the state measured at its first cycle, as in multiple shooting
/// (not a segment of 5 s: replay/Segments.h).
struct Window {
  std::size_t from = 0, to = 0;       ///< cycles [from, to)
  std::vector<MeasuredState> starts;  ///< per joint; NaN where its position is not measured
};

/// Windows of `seconds`, or of twelve cycles of a slow log if that is more. Each begins where the speeds are
/// known best within half a window after the one before: not where a command jumps. noises: per signal,
/// standard deviations of its readings.
std::vector<Window> windowsIn(const Trial& trial, double seconds, const std::vector<double>& noises);

/// Of the starts, to see what their errors do: all positions and speeds off by so much [rad, rad/s].
struct StartShift {
  double position = 0, speed = 0;
};

/// The trial with its replay going on from the measured state at the start of each window.
Trial restartedAt(const std::vector<Window>& windows, Trial trial, const StartShift& shift = {});

}  // namespace plumbline::gap
