#pragma once
#include <memory>
#include <vector>

#include "simulation/referee/Rule.h"

namespace plumbline::simulation {

/// Who plays, and who touched the ball, in a cycle.
struct Observation {
  std::vector<Member> members;      ///< players with a team, in the order in which they came
  int agents = 0;                   ///< those without one as well
  std::vector<RobotHandle> atBall;  ///< robots that touched the ball, the first first
};

/// The league's referee (rcssserver3d 0.7.3, soccerruleaspect.cpp): it calls the rules that are linked, each
/// of which has a file in rules/, in the order of their numbers.
class Referee {
public:
  Referee(const Rules& rules, const RandomStream& random, const FieldSize& field = {});

  /// Judges the cycle that has just passed; may move the ball and the players and freeze joints. True if the
  /// teams changed ends: the members' sides are to be swapped.
  bool update(Game& game, World& world, const Observation& observation, double seconds);

  /// A trainer's command. Side none: the side that begins, else a random one.
  void kickOff(Game& game, World& world, TeamSide side);
  /// A trainer's command: play continues where the ball is.
  void dropBall(Game& game, World& world);
  /// A trainer's wish: selected players step back.
  void clearSelected(Game& game, World& world, const std::vector<Member>& members);
  /// A player requests pass mode.
  void askForPass(Game& game, World& world, int playerId);

  /// Whether a player's words do not reach another one, by any rule.
  bool loses(const Words& words) const;

  const Rules& rules() const { return rules_; }

private:
  Match match(Game& game, World& world, double seconds = 0.02);
  void updateParticipants(World& world, const std::vector<Member>& members);
  void watchBall(Match& match, const Observation& observation);
  void judgeFouls(Match& match);

  Rules rules_;
  FieldSize field_;
  RandomStream random_;
  MatchMemory memory_;
  std::vector<std::unique_ptr<Rule>> inOrder_;
};

}  // namespace plumbline::simulation
