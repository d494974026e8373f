#pragma once
#include <Eigen/Core>

namespace plumbline {

/// Maps any number into a box, one coordinate at a time, so that a search without bounds stays inside one. It
/// is the identity in the inside and a parabola in a margin at each bound, mirrored beyond. The parabola
/// meets the bound with slope 0: no candidate is lost, none is piled up on the bound's outside. The margin is
/// a tenth of the width, or (1 + |bound|) / 20 where the other bound is missing, and at most a tenth of the
/// width. It is the method of Hansen's pycma ("BoundTransform").
class BoxTransform {
public:
  BoxTransform(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

  /// Whether any coordinate has a bound; without one toBox changes nothing.
  bool bounds() const { return bounds_; }
  double toBox(Eigen::Index coordinate, double x) const;
  /// The number that toBox maps there; `y` inside the box.
  double fromBox(Eigen::Index coordinate, double y) const;
  Eigen::VectorXd toBox(const Eigen::VectorXd& x) const;
  Eigen::VectorXd fromBox(const Eigen::VectorXd& y) const;

private:
  Eigen::VectorXd lower_, upper_, lowerMargin_, upperMargin_;
  bool bounds_;
};

}  // namespace plumbline
