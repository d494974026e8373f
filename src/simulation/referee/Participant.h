#pragma once
#include <array>

#include "robot/RobotModel.h"
#include "simspark/TeamSide.h"
#include "simulation/referee/Fouls.h"
#include "simulation/referee/FrozenLimbs.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

/// Who is on the field. `frozen` are the joints that take no speed; the referee sets them.
struct Member {
  int id = 0;
  simspark::TeamSide side = simspark::TeamSide::none;
  int unum = 0;
  RobotHandle robot = -1;
  const RobotModel* model = nullptr;
  JointSet* frozen = nullptr;
  bool selected = false;  ///< by a trainer
};

/// A player as the referee knows it: its state in this cycle, and its offences. Durations are
/// counted in cycles.
struct Participant : Member {
  explicit Participant(const Member& member) : Member(member) { velocities.fill(Vec3::Zero()); }

  static constexpr double never = -1000;   ///< a game time long ago [s]
  static constexpr int longAgo = 1 << 20;  ///< so many cycles

  BodyState torso;
  std::array<Vec3, 3> velocities;  ///< of the last cycles, the newest first [m/s]
  double ballDistance = 1000;      ///< along the ground [m]
  int ballRank = 1;                ///< 1: the nearest of its team to the ball
  int goalRank =
      1;  ///< 1: the nearest to its goal of those in the penalty area before, the goalie before all
  bool inOwnArea = false, wasInOwnArea = false;

  // As if it had stood for five seconds, and not moved by the referee for one.
  int onGround = 0, notStanding = 0, standing = 250;
  int sinceBallTouch = 50, sinceCollision = 10, sinceMoved = 50;

  Foul::Kind foul = Foul::Kind::none;
  int foulCycles = 0;
  bool movedForFoul = false;  ///< its rule has put it where it may be
  FrozenLimbs limbs;
  double lastSelfCollision = never;  ///< game time [s]

  int lastGroupSize = 1;  ///< of those who touched each other, in the cycle before

  Vec2 place() const { return torso.pose.translation().head<2>(); }
  Vec2 velocity() const { return (velocities[0] + velocities[1] + velocities[2]).head<2>() / 3; }
  bool goalie() const { return unum == 1; }
  /// Called for a foul: no further one is looked for until it is dealt with.
  bool offends() const { return foul != Foul::Kind::none; }
  void commit(Foul::Kind kind, bool moved = false) {
    foul = kind;
    movedForFoul = moved;
    ++foulCycles;
  }
};

}  // namespace plumbline::simulation
