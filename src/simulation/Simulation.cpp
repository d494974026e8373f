#include "simulation/Simulation.h"

#include <algorithm>
#include <cmath>

#include "math/Angle.h"
#include "simulation/Trainer.h"
#include "simulation/league/MakeWorld.h"

namespace plumbline::simulation {

using simspark::AgentCommand;

namespace {

constexpr double agentRadius =
    0.4;  ///< the league's idea of a robot's size; also the height a beam puts it to [m]
constexpr double hearingRange = 50;  ///< [m]
const Vec3 spawn(0, -1, 1.5);
constexpr double spawnHeading = pi / 2;
constexpr double spawnDistance = 1;  ///< of a new robot from others [m]

Pose3 upright(const Vec3& position, double heading) { return translation(position) * rotationZ(heading); }

/// A place as its own team sees it, in the field frame.
Pose2 toField(const Pose2& place, TeamSide side) {
  return side == TeamSide::right ? Pose2(-place.x(), -place.y(), normalizeAngle(place.heading + pi)) : place;
}

}  // namespace

Simulation::Simulation(const SimulationConfig& config) : config_(config), world_(makeWorld(config_.world)) {
  visible_.marks = FieldMarks(field());
  reset();
}

void Simulation::reset() {
  world_->reset();
  players_.clear();
  killed_.clear();
  game_ = Game();
  teams_ = Teams(config_.rules.types);
  referee_ = std::make_unique<Referee>(config_.rules, RandomStream(config_.seed), field());
  starts_.fill(Vec2(-field().length / 2 + 2 * agentRadius, field().width / 2 - 2 * agentRadius));
  starts_[1].x() *= -1;
  nextId_ = 1;
  cycles_ = config_.firstCycle;
  ++version_;
}

std::map<PlayerId, PlayerId> Simulation::restart(std::optional<std::uint64_t> seed) {
  struct Place {
    PlayerId id;
    int type, unum;
    std::string team;
  };
  std::vector<Place> places;
  for (const auto& [id, player] : players_) {
    const bool inTeam = player->side != TeamSide::none;
    places.push_back(
        {id, player->type(), player->unum, inTeam ? game_.teams[Game::index(player->side)] : std::string()});
  }
  if (seed) config_.seed = *seed;
  reset();
  std::map<PlayerId, PlayerId> ids;
  for (const Place& place : places) {
    const PlayerId id = addPlayer(place.type);
    ids[place.id] = id;
    if (place.unum == 0) continue;
    AgentCommand command;
    command.init = simspark::InitRequest{place.unum, place.team};
    act(id, command);
  }
  return ids;
}

PlayerId Simulation::addPlayer(int type) {
  const PlayerId id = nextId_;
  auto player = std::make_unique<Player>(id, type, config_.players, config_.seed);
  player->robot = world_->addRobot(player->model(), upright(freeSpawn(), spawnHeading));
  players_.emplace(id, std::move(player));
  ++nextId_;
  ++version_;
  return id;
}

/// The league's server puts all new robots into one spot, where simultaneous robots burst apart.
Vec3 Simulation::freeSpawn() const {
  const auto isFree = [this](const Vec3& place) {
    return std::none_of(players_.begin(), players_.end(), [&](const auto& entry) {
      const Vec3 way = world_->torso(entry.second->robot).pose.translation() - place;
      return way.head<2>().norm() < spawnDistance;
    });
  };
  Vec3 place = spawn;
  for (int i = 1; !isFree(place); ++i) {
    const int away = (i + 1) / 2;  // to either side in turn
    place.x() = spawn.x() + (i % 2 ? away : -away) * spawnDistance;
  }
  return place;
}

void Simulation::removePlayer(PlayerId id) {
  const auto it = players_.find(id);
  if (it == players_.end()) return;
  world_->removeRobot(it->second->robot);
  teams_.release(it->second->side, it->second->unum, it->second->type());
  players_.erase(it);
  ++version_;
}

std::string Simulation::act(PlayerId id, const AgentCommand& command) {
  Player& player = *players_.at(id);
  std::string problem;
  if (command.init) initPlayer(player, *command.init, problem);
  player.drive(*world_, command.velocity);
  if (command.pass) referee_->askForPass(game_, *world_, id);
  if (command.beam) beam(player, *command.beam);
  if (command.say) say(player, *command.say);
  return problem;
}

void Simulation::initPlayer(Player& player, const simspark::InitRequest& init, std::string& problem) {
  if (player.side != TeamSide::none) {
    problem = "team " + init.team + ": this robot has its number already";
    return;
  }
  const Teams::Place place = teams_.request(init.team, init.unum, player.type());
  for (const TeamSide side : {TeamSide::left, TeamSide::right})
    game_.teams[Game::index(side)] = teams_.name(side);
  if (!place.problem.empty()) {
    problem = place.problem;
    return;
  }
  player.side = place.side;
  player.unum = place.unum;
  const Pose2 start = nextStart(place.side);
  world_->moveRobot(player.robot, upright(Vec3(start.x(), start.y(), agentRadius), start.heading));
  ++version_;
}

/// Along the side of the field, a new row behind a full one.
Pose2 Simulation::nextStart(TeamSide side) {
  Vec2& next = starts_[Game::index(side)];
  const Vec2 start = next;
  next.y() -= 3 * agentRadius;
  if (next.y() < -field().width / 2)
    next = Vec2(next.x() + 2 * agentRadius, field().width / 2 - 2 * agentRadius);
  return Pose2(start, side == TeamSide::right ? pi : 0);
}

void Simulation::beam(Player& player, const Pose2& place) {
  const bool allowed = game_.mode == PlayMode::beforeKickOff || game_.mode == PlayMode::goalLeft ||
                       game_.mode == PlayMode::goalRight;
  if (!allowed || player.side == TeamSide::none) return;
  Pose2 start = player.disturbed(place);
  if (!config_.rules.moves.startAnywhere) {
    start.position.x() = std::clamp(start.x(), -field().length / 2, 0.0);
    start.position.y() = std::clamp(start.y(), -field().width / 2, field().width / 2);
  }
  start = toField(start, player.side);
  world_->moveRobot(player.robot, upright(Vec3(start.x(), start.y(), agentRadius), start.heading));
}

void Simulation::say(const Player& speaker, const std::string& text) {
  if (speaker.side == TeamSide::none) return;
  const Vec3 from = world_->torso(speaker.robot).pose.translation();
  const std::string& team = game_.teams[Game::index(speaker.side)];
  for (auto& [id, listener] : players_) {
    if (listener->side == TeamSide::none) continue;
    if (id == speaker.id()) {
      listener->hearing.hearSelf(text);
      continue;
    }
    Vec3 way = from - world_->torso(listener->robot).pose.translation();
    if (way.norm() > hearingRange) continue;
    if (referee_->loses({config_.seed, cycles_, speaker.id(), id})) continue;
    if (listener->side == TeamSide::right) way = Vec3(-way.x(), -way.y(), way.z());
    listener->hearing.hear(text, team, std::atan2(way.y(), way.x()), listener->side == speaker.side);
  }
}

std::string Simulation::train(const simspark::TrainerCommand& command) {
  const auto remove = [this](PlayerId id) {
    removePlayer(id);
    killed_.push_back(id);
  };
  return Trainer({*world_, game_, *referee_, players_, members(), field(), remove}).carryOut(command);
}

void Simulation::step() {
  world_->step();
  ++cycles_;
  const Observation observation{members(), static_cast<int>(players_.size()), world_->ballTouchedBy()};
  if (referee_->update(game_, *world_, observation, config_.world.stepSeconds)) changeSides();
  makeSenses();
}

std::vector<Member> Simulation::members() const {
  std::vector<Member> members;
  for (const auto& [id, player] : players_)
    if (player->side != TeamSide::none)
      members.push_back({id, player->side, player->unum, player->robot, &player->model(), &player->frozen,
                         player->selected});
  return members;
}

/// As on the league's server, players are not informed.
void Simulation::changeSides() {
  teams_.swapSides();
  for (auto& [id, player] : players_) player->side = simspark::opponent(player->side);
  ++version_;
}

bool Simulation::finished() const {
  constexpr double afterGame = 10;  ///< [s]
  return config_.rules.time.quitAfterGame && game_.mode == PlayMode::gameOver &&
         game_.modeTime() >= afterGame;
}

void Simulation::makeSenses() {
  visible_.ball = world_->ball().pose.translation();
  visible_.players.clear();
  simspark::GroundTruth truth;
  truth.ball = visible_.ball;
  for (const auto& [id, player] : players_) {
    if (player->side == TeamSide::none) continue;
    const std::string& team = game_.teams[Game::index(player->side)];
    visible_.players.push_back(player->visibleParts(*world_, team));
    if (!config_.players.groundTruth) continue;
    const Pose3 torso = world_->torso(player->robot).pose;
    truth.players.push_back({team, player->unum, torso.translation().x(), torso.translation().y(),
                             std::atan2(torso.linear()(1, 0), torso.linear()(0, 0))});
  }
  for (const auto& [id, player] : players_)
    player->sense(*world_, game_, time(), visible_, config_.players.groundTruth ? &truth : nullptr);
}

}  // namespace plumbline::simulation
