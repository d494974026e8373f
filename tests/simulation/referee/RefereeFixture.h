#pragma once
#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "../FakeWorld.h"
#include "math/Angle.h"
#include "simspark/LeagueRobots.h"
#include "simulation/referee/Referee.h"

namespace plumbline::test {

using simulation::BallTouch;
using simulation::Foul;
using simulation::Game;
using simulation::PlayMode;
using simulation::TeamSide;

/// A game whose players and ball go where the test puts them, judged cycle by cycle.
class RefereeTest : public testing::Test {
protected:
  static constexpr double dt = 0.02;
  static constexpr double standing = 0.385;  ///< height of the torso of a robot of type 0 [m]
  static constexpr TeamSide left = TeamSide::left, right = TeamSide::right;

  Game game;
  FakeWorld world;
  simulation::Rules rules;
  const RobotModel model = simsparkRobot(0);

  struct Man {
    TeamSide side;
    int unum;
    simulation::RobotHandle robot;
    simulation::JointSet frozen{};
    bool selected = false;
  };
  /// A player that stands there, facing the right goal.
  Man& add(TeamSide side, int unum, double x, double y, double z = standing) {
    men.push_back(std::make_unique<Man>());
    *men.back() = {side, unum, world.addRobot(model, translation(x, y, z))};
    return *men.back();
  }
  void put(const Man& man, double x, double y, double z = standing) {
    world.robots.at(man.robot).torso.pose = translation(x, y, z);
  }
  void setVelocity(const Man& man, double x, double y) {
    world.robots.at(man.robot).torso.linearVelocity = Vec3(x, y, 0);
  }
  Vec3 place(const Man& man) const { return world.robots.at(man.robot).torso.pose.translation(); }
  int moves(const Man& man) const { return world.robots.at(man.robot).moves; }
  void ball(double x, double y, double z = FieldSize().ballRadius) {
    world.ballState.pose = translation(x, y, z);
  }
  Vec3 ball() const { return world.ballState.pose.translation(); }

  /// So many seconds; in the first cycle the ball is touched by that player.
  void pass(double seconds, const Man* toucher = nullptr) {
    for (int i = 0; i < int(seconds / dt + 0.5); ++i) {
      simulation::Observation seen;
      int id = 0;
      for (const auto& man : men)
        seen.members.push_back({++id, man->side, man->unum, man->robot, &model, &man->frozen, man->selected});
      seen.agents = static_cast<int>(men.size()) + strangers;
      if (i == 0 && toucher) seen.atBall.push_back(toucher->robot);
      changedSides = referee().update(game, world, seen, dt) || changedSides;
    }
  }
  void cycle(const Man* toucher = nullptr) { pass(dt, toucher); }
  void playOn(const Man* toucher = nullptr) {
    game.setMode(PlayMode::playOn);
    cycle(toucher);
  }
  simulation::Referee& referee() {
    if (!referee_) referee_ = std::make_unique<simulation::Referee>(rules, simulation::RandomStream(1));
    return *referee_;
  }
  /// Kinds of the fouls reported, with who did them, without repetitions.
  std::vector<std::pair<Foul::Kind, int>> fouls() const {
    std::vector<std::pair<Foul::Kind, int>> found;
    for (const Foul& foul : game.fouls.since(0)) {
      const std::pair<Foul::Kind, int> entry{foul.kind, foul.side == right ? -foul.unum : foul.unum};
      if (found.empty() || found.back() != entry) found.push_back(entry);
    }
    return found;
  }

  int strangers = 0;  ///< agents without a team
  bool changedSides = false;
  std::vector<std::unique_ptr<Man>> men;

private:
  std::unique_ptr<simulation::Referee> referee_;
};

}  // namespace plumbline::test
