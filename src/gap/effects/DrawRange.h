#pragma once
#include <string_view>

namespace plumbline::gap {

/// How blind benchmarks draw an effect: where, and how large.
struct DrawRange {
  enum class Where { nowhere, joint, jointOrAll, all, link, imu, foot, ground };
  /// Unit of the sizes: plain, the joint's largest torque, its kd, or the inverse of its largest torque.
  enum class Unit { plain, torque, damping, perTorque };
  enum class Growth {
    distance,  ///< from 0: twice as strong is twice the value
    factor,    ///< from 1: twice as strong is its square
    limit      ///< from infinity: twice as strong is half
  };
  /// A form of the effect that the engine knows by name; both values are equally likely.
  struct Choice {
    std::string_view name = {}, first = {}, second = {};
  };

  Where where = Where::nowhere;  ///< nowhere: it is not drawn
  double low = 0, high = 0;
  double low2 = 0, high2 = 0;  ///< a second range, equally likely; none if high2 is 0
  Unit unit = Unit::plain;
  Growth growth = Growth::distance;
  bool bothSigns = false;
  std::string_view axes = {};
  bool floatingBase = false;  ///< only a robot on its feet shows it
  Choice choice = {};
};

}  // namespace plumbline::gap
