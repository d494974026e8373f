#pragma once
#include <string_view>

namespace plumbline::gap {

/// How blind benchmarks draw an effect: where, and how large.
struct DrawRange {
  enum class Where { nowhere, joint, jointOrAll, all, link, imu, foot, ground };
  /// In what sizes are given: as they are, in the joint's largest torque, in its kd, per its largest torque.
  enum class Unit { plain, torque, damping, perTorque };
  enum class Growth {
    distance,  ///< from nothing: twice as strong is twice the value
    factor,    ///< from 1: twice as strong is its square
    limit      ///< from infinity: twice as strong is half
  };
  /// A way of building it that the engine takes by name; either value as likely.
  struct Choice {
    std::string_view name = {}, first = {}, second = {};
  };

  Where where = Where::nowhere;  ///< nowhere: it is not drawn
  double low = 0, high = 0;
  double low2 = 0, high2 = 0;  ///< another range, as likely; none where high2 is 0
  Unit unit = Unit::plain;
  Growth growth = Growth::distance;
  bool bothSigns = false;
  std::string_view axes = {};
  bool standing = false;  ///< only seen on the feet
  Choice choice = {};
};

}  // namespace plumbline::gap
