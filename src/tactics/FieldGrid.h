#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "math/Types.h"

namespace plumbline {

/// The ball's place [m, team's frame, opponents' goal at +x] and which team is nearer to it: an advantage
/// from -1 (theirs) over 0 (nobody's) to 1 (ours).
struct BallState {
  Vec2 place = Vec2::Zero();
  double advantage = 0;
  /// The same as the other team sees it.
  BallState mirrored() const { return {-place, -advantage}; }
};

/// The advantage from the times [s] that the first player of each team needs to the ball: a difference of 2 s
/// or more is the full advantage.
double ballAdvantage(double ourSeconds, double theirSeconds);

/// A regular grid over ball states: x, |y| and advantage -1, 0, 1. The left half of the field is the right
/// one's mirror image. A state lies between up to eight points, with weights of sum 1 (trilinear).
class FieldGrid {
public:
  static constexpr std::size_t advantages = 3;
  struct Weight {
    std::size_t point = 0;
    double weight = 0;
  };

  /// x: rising, symmetric about 0; y: rising from 0; each at least two [m].
  FieldGrid(std::vector<double> x, std::vector<double> y);

  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }
  std::size_t size() const { return x_.size() * y_.size() * advantages; }
  /// Index of a point from its indices along x, y and advantage (0: -1, 1: 0, 2: 1).
  std::size_t point(std::size_t ix, std::size_t iy, std::size_t ia) const {
    return (ia * y_.size() + iy) * x_.size() + ix;
  }
  BallState state(std::size_t point) const;
  /// Beyond its borders a state counts as at the border.
  std::array<Weight, 8> weights(const BallState& state) const;

private:
  std::vector<double> x_, y_;
};

}  // namespace plumbline
