#pragma once
#include <optional>

#include "simulation/Game.h"
#include "simulation/Random.h"
#include "simulation/World.h"
#include "simulation/referee/BallWatch.h"

namespace plumbline::simulation {

/// Durations of the league's rules [s].
struct Rules {
  double halfTime = 300;
  double goalPause = 3;
  double kickInPause = 1;
  double dropBall = 15;  ///< nobody touches the ball: play on
  /// Kick off by oneself after so long before kick-off; nothing: a trainer does it.
  std::optional<double> kickOffAfter;
};

/// The rules one robot and a goal need: kick-off, play on, goals, the ball out of the field, time and halves.
/// Fouls, and keeping players away from the ball, are not judged yet.
class Referee {
public:
  Referee(const Rules& rules_, const Random& random_) : rules(rules_), random(random_) {}

  struct Observation {
    bool playersPresent = false;
    std::optional<BallWatch::Touch> touch;  ///< a player touched the ball in this cycle
  };

  /// Judges the cycle that has just passed; may move the ball.
  void update(Game& game, World& world, const Observation& observation, double seconds);
  /// side none: the side whose turn it is, else one by lot.
  void kickOff(Game& game, TeamSide side);
  /// Play goes on where the ball is, or on the edge of the penalty area and the field.
  void dropBall(Game& game, World& world);

private:
  void checkTime(Game& game);
  void beforeKickOff(Game& game, World& world, const Observation& observation);
  void kickingOff(Game& game, World& world);
  void playOn(Game& game, World& world);
  void ballLeftField(Game& game, World& world);
  void deadBall(Game& game, World& world);
  void goalPause(Game& game, World& world);
  void award(Game& game, PlayMode left, TeamSide side, const Vec3& position);
  void placeBall(World& world, const Vec3& position);
  void drop(Game& game, World& world, Vec3 position);

  Rules rules;
  Random random;
  BallWatch ball;
  Vec3 kickPosition = Vec3::Zero();
  bool kickTaken = false;
  TeamSide nextHalfKickOff = TeamSide::left;
  int lastKickOffHalf = 0;
};

}  // namespace plumbline::simulation
