#pragma once
#include <array>
#include <vector>

#include "field/FieldSize.h"
#include "simulation/referee/BallWatch.h"
#include "simulation/referee/Game.h"
#include "simulation/referee/Participant.h"
#include "simulation/referee/Rules.h"
#include "simulation/world/RandomStream.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

/// A restart that was taken: until somebody else touches the ball, its taker must not, and may not score from
/// an indirect one.
struct TakenKick {
  bool watched = false;
  bool indirect = false;
  BallTouch taker;  ///< who took a restart last, and when
};

/// What the kick-off's team must do before it may score.
struct TakenKickOff {
  bool mayScore = true;
  BallTouch taker;
};

/// A side's last pass mode.
struct PassRecord {
  double last = Participant::never;  ///< game time when it was last on [s]
  Vec2 ball = Vec2::Zero();          ///< where it lay
  bool leftCircle = false;           ///< the ball was too far from there since
  int firstToucher = 0;              ///< number of the first player of the side at the ball since; 0: nobody
  bool moreTouched = false;          ///< than that one
  bool clearedToScore = false;
};

/// The referee's state from cycle to cycle, except the game state that is sent to everyone.
struct MatchMemory {
  BallWatch ball;
  std::vector<Participant> participants;  ///< with a team, in the order in which they came
  int agents = 0;                         ///< those without a team as well
  Vec3 kickPosition = Vec3::Zero();       ///< where the next restart is
  bool repelKickers = false;              ///< when the ball is laid down there
  TakenKick kick;
  TakenKickOff kickOff;
  std::array<PassRecord, 2> pass;    ///< left, right
  std::array<int, 2> inOwnArea{};    ///< players of a side in their penalty area
  std::array<int, 2> movedInside{};  ///< more of them by the referee's moves in this cycle
  TeamSide nextHalfKickOff = TeamSide::left;
  int lastKickOffHalf = 0;
};

/// One cycle of a game, as the rules see it.
struct Match {
  const Rules& rules;
  const FieldSize& field;
  Game& game;
  World& world;
  RandomStream& random;
  MatchMemory& memory;
  /// Robots that touched each other in this cycle.
  const std::vector<RobotContact>& contacts;
  double step = 0.02;  ///< of a cycle [s]
  /// Play mode for judging this cycle; game.mode is the result.
  PlayMode mode = PlayMode::beforeKickOff;
  bool settled = false;      ///< a rule has decided what follows from where the ball is
  bool suspended = false;    ///< players may stand anywhere: no fouls, and none is held against them
  bool changedEnds = false;  ///< the teams did

  /// Whether goals count and the ball can go out.
  bool ballInPlay() const {
    return mode == PlayMode::playOn || mode == PlayMode::passLeft || mode == PlayMode::passRight;
  }

  BallWatch& ball() { return memory.ball; }
  std::vector<Participant>& participants() { return memory.participants; }
  PassRecord& pass(TeamSide side) { return memory.pass[Game::index(side)]; }
  double cycles(double seconds) const { return seconds / step; }

  /// Null if that robot or number is nobody's.
  Participant* find(RobotHandle robot);
  Participant* find(TeamSide side, int unum);
  /// Players of a side (none: of both) in random order, so that no number is preferred.
  std::vector<Participant*> inRandomOrder(TeamSide side);
  /// Both sides, in random order.
  std::array<TeamSide, 2> sidesInRandomOrder();

  /// Lays the ball down, or shoots it from there [m/s]; the next restart is there, too.
  void placeBall(const Vec3& position, const Vec3& velocity = Vec3::Zero());
  /// Puts a player's torso there, turned as it is, at rest, even if others are there.
  void move(Participant& player, const Vec3& place);
};

}  // namespace plumbline::simulation
