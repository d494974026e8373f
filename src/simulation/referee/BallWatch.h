#pragma once
#include "simspark/TeamSide.h"
#include "simulation/World.h"

namespace plumbline::simulation {

/// What the referee knows of the ball: where it is, was last on the field, and who touched it last.
class BallWatch {
public:
  struct Touch {
    simspark::TeamSide side = simspark::TeamSide::none;
    int unum = 0;
    double time = -1;  ///< game time [s]
  };

  void update(const Vec3& ballPosition);
  void touched(const Touch& touch) { lastTouch_ = touch; }
  void reset() { *this = BallWatch(); }

  const Vec3& position() const { return current; }
  const Vec3& lastOnField() const { return valid; }
  bool onField() const;
  /// Whoever touched it last; side none: nobody yet.
  const Touch& lastTouch() const { return lastTouch_; }
  /// The side whose goal the ball is in as a whole, or none. Seen from the way since the last update, so that
  /// a fast ball is not missed and one beside or above the goal is not counted.
  simspark::TeamSide inGoalOf() const;

private:
  Vec3 current = Vec3::Zero(), previous = Vec3::Zero(), valid = Vec3::Zero();
  Touch lastTouch_;
};

}  // namespace plumbline::simulation
