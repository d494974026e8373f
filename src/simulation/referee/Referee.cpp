#include "simulation/referee/Referee.h"

#include <algorithm>

#include "simulation/referee/Conduct.h"
#include "simulation/referee/Reposition.h"
#include "simulation/referee/rules/BallOut.h"
#include "simulation/referee/rules/Charging.h"
#include "simulation/referee/rules/Crowding.h"
#include "simulation/referee/rules/DoubleTouch.h"
#include "simulation/referee/rules/DropBall.h"
#include "simulation/referee/rules/Goal.h"
#include "simulation/referee/rules/HalfTime.h"
#include "simulation/referee/rules/IllegalDefence.h"
#include "simulation/referee/rules/Incapable.h"
#include "simulation/referee/rules/KickOff.h"
#include "simulation/referee/rules/PassMode.h"
#include "simulation/referee/rules/Penalty.h"
#include "simulation/referee/rules/Restart.h"
#include "simulation/referee/rules/SelfCollision.h"
#include "simulation/referee/rules/Touching.h"

namespace plumbline::simulation {

namespace {

void playOn(Match& match) {
  watchPass(match);
  if (doubleTouch(match) || goal(match)) return;
  ballOut(match);
}

void passMode(Match& match, TeamSide side) {
  passModeBefore(match, side);
  playOn(match);
  passModeAfter(match, side);
}

/// Fouls that need a look at the player alone, in the league's order.
void judge(Match& match, Participant& player) {
  if (player.offends()) return;
  if (crowds(match, player))
    player.commit(Foul::Kind::crowding);
  else if (defendsIllegally(match, player))
    punishDefence(match, player);
  else if (incapable(match, player))
    player.commit(Foul::Kind::incapable);
}

}  // namespace

Match Referee::match(Game& game, World& world, double seconds) {
  return {rules_, field, game, world, random, memory, world.robotContacts(), seconds};
}

bool Referee::update(Game& game, World& world, const Observation& observation, double seconds) {
  Match match = this->match(game, world, seconds);
  game.advance(seconds);
  meet(world, observation.members);
  memory.agents = observation.agents;
  watchBall(match, observation);

  const bool changed = halfTime(match);
  watchKickOff(match);
  const bool stands = judgeMode(match);
  observeVelocities(match);
  if (stands) {
    for (Participant& player : memory.participants) forgive(match, player);
    thawJoints(match, true);
  } else {
    judgeFouls(match);
  }
  for (const TeamSide side : {TeamSide::left, TeamSide::right})
    game.passScoreWait[Game::index(side)] = game.mode == PlayMode::playOn ? passScoreWait(match, side) : 0;
  return changed;
}

/// Keeps what is known of those who are still there.
void Referee::meet(World& world, const std::vector<Member>& members) {
  std::vector<Participant> present;
  present.reserve(members.size());
  for (const Member& member : members) {
    const auto known = std::find_if(memory.participants.begin(), memory.participants.end(),
                                    [&](const Participant& p) { return p.id == member.id; });
    if (known == memory.participants.end()) {
      present.emplace_back(member);
    } else {
      static_cast<Member&>(*known) = member;
      present.push_back(*known);
    }
    present.back().torso = world.torso(member.robot);
  }
  memory.participants = std::move(present);
}

void Referee::watchBall(Match& match, const Observation& observation) {
  std::vector<BallTouch> touching;
  for (const RobotHandle robot : observation.atBall)
    if (const Participant* player = match.find(robot))
      touching.push_back({player->side, player->unum, match.game.time});
  memory.ball.update(match.world.ball(), touching);
}

bool Referee::judgeMode(Match& match) {
  switch (match.game.mode) {
    case PlayMode::beforeKickOff:
      beforeKickOff(match);
      return true;
    case PlayMode::kickOffLeft:
    case PlayMode::kickOffRight:
      kickingOff(match, sideOf(match.game.mode, PlayMode::kickOffLeft));
      return false;
    case PlayMode::goalLeft:
    case PlayMode::goalRight:
      afterGoal(match, sideOf(match.game.mode, PlayMode::goalLeft));
      return true;
    case PlayMode::playOn:
      playOn(match);
      return false;
    case PlayMode::passLeft:
    case PlayMode::passRight:
      passMode(match, sideOf(match.game.mode, PlayMode::passLeft));
      return false;
    case PlayMode::offsideLeft:
    case PlayMode::offsideRight:
    case PlayMode::gameOver:
      return false;
    default:
      restart(match);
      return false;
  }
}

void Referee::judgeFouls(Match& match) {
  observeConduct(match);
  observeBallTouches(match);
  judgeCharging(match);
  judgeSelfCollisions(match);
  for (const TeamSide side : {TeamSide::left, TeamSide::right})
    for (Participant* player : match.inRandomOrder(side)) judge(match, *player);
  judgeTouching(match);
  punishOffenders(match);
  thawJoints(match, false);
}

void Referee::kickOff(Game& game, World& world, TeamSide side) {
  Match match = this->match(game, world);
  startKickOff(match, side);
}

void Referee::dropBall(Game& game, World& world) {
  Match match = this->match(game, world);
  simulation::dropBall(match, world.ball().pose.translation());
}

void Referee::clearSelected(Game& game, World& world, const std::vector<Member>& members) {
  meet(world, members);
  Match match = this->match(game, world);
  simulation::clearSelected(match);
}

void Referee::askForPass(Game& game, World& world, int playerId) {
  Match match = this->match(game, world);
  for (const Participant& player : memory.participants)
    if (player.id == playerId) return simulation::askForPass(match, player);
}

}  // namespace plumbline::simulation
