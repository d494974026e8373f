#include "simulation/referee/Referee.h"

#include <algorithm>

#include "simulation/referee/Conduct.h"
#include "simulation/referee/DropBall.h"
#include "simulation/referee/Reposition.h"
#include "simulation/referee/StartKickOff.h"

namespace plumbline::simulation {

Referee::Referee(const Rules& rules, const RandomStream& random_, const FieldSize& field_)
    : rules_(rules), field(field_), random(random_) {
  memory.ball = BallWatch(field);
  if (rules.kickOff.byLot) memory.nextHalfKickOff = TeamSide::none;
  for (const RuleEntry& rule : registeredRules()) inOrder.push_back(rule.make());
}

Match Referee::match(Game& game, World& world, double seconds) {
  return {rules_, field, game, world, random, memory, world.robotContacts(), seconds};
}

bool Referee::update(Game& game, World& world, const Observation& observation, double seconds) {
  Match match = this->match(game, world, seconds);
  game.advance(seconds);
  meet(world, observation.members);
  memory.agents = observation.agents;
  watchBall(match, observation);

  for (const auto& rule : inOrder) rule->begin(match);
  match.mode = game.mode;
  for (const auto& rule : inOrder) rule->play(match);
  for (const auto& rule : inOrder) rule->afterPlay(match);
  observeVelocities(match);
  if (match.suspended)
    for (Participant& player : memory.participants) forgive(match, player);
  else
    judgeFouls(match);
  for (const auto& rule : inOrder) rule->end(match);
  return match.changedEnds;
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

void Referee::judgeFouls(Match& match) {
  observeConduct(match);
  observeBallTouches(match);
  for (const auto& rule : inOrder) rule->judgeAll(match);
  for (const TeamSide side : {TeamSide::left, TeamSide::right})
    for (Participant* player : match.inRandomOrder(side))
      for (const auto& rule : inOrder)
        if (!player->offends()) rule->judgePlayer(match, *player);
  for (const auto& rule : inOrder) rule->judgeGroups(match);
  for (const auto& rule : inOrder) rule->punish(match);
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
    if (player.id == playerId)
      for (const auto& rule : inOrder) rule->passAsked(match, player);
}

}  // namespace plumbline::simulation
