#pragma once
#include <vector>

#include "field/FieldSize.h"
#include "simspark/TeamSide.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

/// A player at the ball.
struct BallTouch {
  simspark::TeamSide side = simspark::TeamSide::none;
  int unum = 0;
  double time = -1;  ///< game time [s]
  bool samePlayer(const BallTouch& other) const { return side == other.side && unum == other.unum; }
};

/// The referee's data about the ball: where it is, where it was last on the field, and which player touched
/// it last.
class BallWatch {
public:
  explicit BallWatch(const FieldSize& field = {}) : field_(field) {}

  /// A cycle has passed; touching: those who touched the ball in it, the first first.
  void update(const BodyState& ball, const std::vector<BallTouch>& touching);
  /// The referee laid the ball down.
  void placed(const Vec3& place);
  void swapSides();

  const Vec3& position() const { return current_; }
  double speed() const { return velocity_.norm(); }  ///< [m/s]
  const Vec3& lastOnField() const { return valid_; }
  bool onField() const;
  /// Whoever touched it last; side none: nobody yet.
  const BallTouch& lastTouch() const { return lastTouch_; }
  bool touchedSince(double time) const {
    return lastTouch_.side != simspark::TeamSide::none && lastTouch_.time > time;
  }
  /// Those who touched it in this cycle.
  const std::vector<BallTouch>& touching() const { return touching_; }
  bool touchedBy(simspark::TeamSide side) const;
  /// The side whose goal the ball is in, or none; as the league's server has it. The ball is in when it
  /// reaches into the goal's inside: the goal less a ball's radius on each side but for the height, so from
  /// its centre on the line. It is also in when it is behind the line and its velocity says that it came
  /// through the goal within a second.
  simspark::TeamSide inGoalOf() const;

private:
  FieldSize field_;
  Vec3 current_ = Vec3::Zero(), velocity_ = Vec3::Zero(), valid_ = Vec3::Zero();
  BallTouch lastTouch_;
  std::vector<BallTouch> touching_;
};

}  // namespace plumbline::simulation
