#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "simspark/AgentCommand.h"
#include "simspark/TrainerCommand.h"
#include "simulation/Player.h"
#include "simulation/Teams.h"
#include "simulation/referee/Game.h"
#include "simulation/referee/Referee.h"
#include "simulation/world/World.h"

namespace plumbline::simulation {

struct SimulationConfig {
  WorldConfig world;
  Rules rules;
  PlayerConfig players;
  std::uint64_t seed = 1;
  std::uint64_t firstCycle = 0;  ///< the clock begins there: as in a simulation that has run for long
};

/// A whole game in this process: world, players, referee, sensors. No sockets, no clock: the same calls give
/// the same bytes. In a cycle the server calls act() for every received message, sends message() of every
/// player, and calls step().
class Simulation {
public:
  explicit Simulation(const SimulationConfig& config);

  /// A robot of a league type at the league's spawn, or a metre or more next to it while another one is
  /// there; without a team. Errors: std::out_of_range for another type.
  PlayerId addPlayer(int type);
  void removePlayer(PlayerId id);
  /// Carries out what a player commands (scene and syn are the connection's business). Returns why something
  /// was refused, one line, or nothing.
  std::string act(PlayerId id, const simspark::AgentCommand& command);

  /// Carries out a trainer's command but those that are the connection's: fullstate, acknowledge, killsim,
  /// clock, viewer, reset.
  /// Returns why not, one line, or nothing.
  std::string train(const simspark::TrainerCommand& command);
  /// Players a trainer had removed since the last call; their connections are to be closed.
  std::vector<PlayerId> takeKilled() { return std::exchange(killed_, {}); }

  /// One cycle of physics, rules, and new senses for everybody.
  void step();
  /// As after construction: no players, clock at its beginning.
  void reset();
  /// As after construction, but with a new robot for every present player, in the order in which they came,
  /// with their teams and numbers. A seed replaces the old one. Returns the new id of each player by the old
  /// one.
  std::map<PlayerId, PlayerId> restart(std::optional<std::uint64_t> seed = {});

  /// Senses made by the last step, as the wire wants them (without frame); empty before the first.
  const std::string& message(PlayerId id) const { return players_.at(id)->message(); }

  const FieldSize& field() const { return config_.world.field; }
  const Game& game() const { return game_; }
  const Rules& rules() const { return referee_->rules(); }
  /// Whether the rules end the simulator a while after the game, and it is time.
  bool finished() const;
  World& world() { return *world_; }
  const World& world() const { return *world_; }
  double time() const { return static_cast<double>(cycles_) * config_.world.stepSeconds; }
  std::uint64_t cycle() const { return cycles_; }
  std::size_t numPlayers() const { return players_.size(); }
  /// By id, in the order in which they came.
  const std::map<PlayerId, std::unique_ptr<Player>>& allPlayers() const { return players_; }
  /// Grows when players come, go or get a number: the monitor's scene must be sent again.
  std::uint64_t sceneVersion() const { return version_; }

private:
  void initPlayer(Player& player, const simspark::InitRequest& init, std::string& problem);
  void beam(Player& player, const Pose2& place);
  void say(const Player& speaker, const std::string& text);
  std::vector<Member> members() const;
  void changeSides();
  void makeSenses();
  Pose2 nextStart(TeamSide side);
  Vec3 freeSpawn() const;

  SimulationConfig config_;
  std::unique_ptr<World> world_;
  Game game_;
  Teams teams_;
  std::unique_ptr<Referee> referee_;
  std::map<PlayerId, std::unique_ptr<Player>> players_;
  std::vector<PlayerId> killed_;
  PlayerId nextId_ = 1;
  std::array<Vec2, 2> starts_;  ///< where the next new player of a team is put
  std::uint64_t cycles_ = 0, version_ = 1;
  VisibleWorld visible_;
};

}  // namespace plumbline::simulation
