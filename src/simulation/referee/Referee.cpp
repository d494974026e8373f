#include "simulation/referee/Referee.h"

#include <algorithm>

#include "simulation/referee/Conduct.h"
#include "simulation/referee/DropBall.h"
#include "simulation/referee/Reposition.h"
#include "simulation/referee/StartKickOff.h"

namespace plumbline::simulation {

Referee::Referee(const Rules& rules, const RandomStream& random, const FieldSize& field)
    : rules_(rules), field_(field), random_(random) {
  memory_.ball = BallWatch(field_);
  if (rules.kickOff.byLot) memory_.nextHalfKickOff = TeamSide::none;
  for (const RuleEntry& rule : registeredRules()) inOrder_.push_back(rule.make());
}

Match Referee::match(Game& game, World& world, double seconds) {
  return {rules_, field_, game, world, random_, memory_, world.robotContacts(), seconds};
}

bool Referee::update(Game& game, World& world, const Observation& observation, double seconds) {
  Match match = this->match(game, world, seconds);
  game.advance(seconds);
  updateParticipants(world, observation.members);
  memory_.agents = observation.agents;
  watchBall(match, observation);

  for (const auto& rule : inOrder_) rule->begin(match);
  match.mode = game.mode;
  for (const auto& rule : inOrder_) rule->play(match);
  for (const auto& rule : inOrder_) rule->afterPlay(match);
  observeVelocities(match);
  if (match.suspended)
    for (Participant& player : memory_.participants) forgive(match, player);
  else
    judgeFouls(match);
  for (const auto& rule : inOrder_) rule->end(match);
  return match.changedEnds;
}

/// Updates the list of participants; what is known of those still there is kept.
void Referee::updateParticipants(World& world, const std::vector<Member>& members) {
  std::vector<Participant> present;
  present.reserve(members.size());
  for (const Member& member : members) {
    const auto known = std::find_if(memory_.participants.begin(), memory_.participants.end(),
                                    [&](const Participant& p) { return p.id == member.id; });
    if (known == memory_.participants.end()) {
      present.emplace_back(member);
    } else {
      static_cast<Member&>(*known) = member;
      present.push_back(*known);
    }
    present.back().torso = world.torso(member.robot);
  }
  memory_.participants = std::move(present);
}

void Referee::watchBall(Match& match, const Observation& observation) {
  std::vector<BallTouch> touching;
  for (const RobotHandle robot : observation.atBall)
    if (const Participant* player = match.find(robot))
      touching.push_back({player->side, player->unum, match.game.time});
  memory_.ball.update(match.world.ball(), touching);
}

void Referee::judgeFouls(Match& match) {
  observeConduct(match);
  observeBallTouches(match);
  for (const auto& rule : inOrder_) rule->judgeAll(match);
  for (const TeamSide side : {TeamSide::left, TeamSide::right})
    for (Participant* player : match.inRandomOrder(side))
      for (const auto& rule : inOrder_)
        if (!player->offends()) rule->judgePlayer(match, *player);
  for (const auto& rule : inOrder_) rule->judgeGroups(match);
  for (const auto& rule : inOrder_) rule->punish(match);
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
  updateParticipants(world, members);
  Match match = this->match(game, world);
  simulation::clearSelected(match);
}

void Referee::askForPass(Game& game, World& world, int playerId) {
  Match match = this->match(game, world);
  for (const Participant& player : memory_.participants)
    if (player.id == playerId)
      for (const auto& rule : inOrder_) rule->passAsked(match, player);
}

bool Referee::loses(const Words& words) const {
  return std::ranges::any_of(inOrder_, [&](const auto& rule) { return rule->loses(rules_, words); });
}

}  // namespace plumbline::simulation
