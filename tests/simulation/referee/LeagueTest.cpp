// The referee in the simulated world: what was done to the league's server by a trainer and two agents, and
// what it did (rcssserver3d 0.7.3 with its own rules); and what monitors get.
#include <gtest/gtest.h>

#include <ostream>

#include "math/Angle.h"
#include "simulation/Simulation.h"
#include "simulation/monitor/MonitorScene.h"

namespace plumbline::simulation {
namespace {

using simspark::AgentCommand;
using simspark::PlayerName;

class League : public testing::Test {
protected:
  SimulationConfig config;
  Simulation& simulation() {
    if (!simulation_) simulation_ = std::make_unique<Simulation>(config);
    return *simulation_;
  }
  PlayerId join(const std::string& team, int unum) {
    const PlayerId id = simulation().addPlayer(0);
    AgentCommand command;
    command.init = simspark::InitRequest{unum, team};
    EXPECT_EQ(simulation().act(id, command), "");
    return id;
  }
  void step(int cycles) {
    for (int i = 0; i < cycles; ++i) simulation().step();
  }
  void put(TeamSide side, int unum, double x, double y, double heading) {
    simulation().train(simspark::MoveAgentCommand{PlayerName{unum, side}, Vec3(x, y, 0.386), heading});
  }
  void playOn(const Vec3& ball) {
    simulation().train(simspark::PlayModeCommand{PlayMode::playOn});
    simulation().train(simspark::BallCommand{ball, Vec3::Zero()});
  }
  Vec3 torso(PlayerId id) {
    return simulation().world().torso(simulation().allPlayers().at(id)->robot).pose.translation();
  }
  double angle(PlayerId id, JointId joint) {
    return toDegrees(simulation().world().readings(simulation().allPlayers().at(id)->robot).angle[joint]);
  }
  std::deque<Foul> fouls() { return simulation().game().fouls.since(0); }

private:
  std::unique_ptr<Simulation> simulation_;
};

TEST_F(League, anArmDrivenIntoTheTorsoFreezesAtTheSameAngles) {
  const PlayerId id = join("Red", 2);
  step(40);
  playOn(Vec3(5, 5, 0.042));
  step(20);
  AgentCommand inwards;
  inwards.velocity[lShoulderPitch] = fromDegrees(70) / 1.2;
  inwards.velocity[lElbowYaw] = fromDegrees(40) / 1.2;
  inwards.velocity[lElbowRoll] = fromDegrees(-60) / 1.2;
  for (int i = 0; i < 60; ++i) {
    simulation().act(id, inwards);
    step(1);
  }
  EXPECT_NEAR(angle(id, lShoulderPitch), 63, 0.01);
  EXPECT_NEAR(angle(id, lElbowYaw), 36, 0.01);
  EXPECT_NEAR(angle(id, lElbowRoll), -54, 0.01);
  ASSERT_EQ(fouls().size(), 1u);
  EXPECT_EQ(fouls()[0].kind, Foul::Kind::selfCollision);
  AgentCommand outwards;
  outwards.velocity[lElbowRoll] = 0.5;
  int cycles = 0;
  while (angle(id, lElbowRoll) < -53.9 && cycles < 100) {
    simulation().act(id, outwards);
    step(1);
    ++cycles;
  }
  EXPECT_NEAR(cycles, 45, 2) << "a second from the collision on, six cycles of which are over";
}

struct Fall {
  double gap;
  bool charges;
  double x;  ///< of the one that fell, before anybody moved it: it lies against the other
};

std::ostream& operator<<(std::ostream& out, const Fall& fall) { return out << fall.gap << " m"; }

class Charge : public League, public testing::WithParamInterface<Fall> {};

TEST_P(Charge, fallingIntoAnOpponentIsOneOnlyWhileStanding) {
  const PlayerId left = join("Red", 2), right = join("Blue", 2);
  step(100);
  playOn(Vec3(-10, 8, 0.042));
  step(20);
  put(TeamSide::right, 2, GetParam().gap, 0, pi);
  put(TeamSide::left, 2, 0, 0, 0);
  AgentCommand wake;
  wake.velocity[headYaw] = 0.1;
  for (int i = 0; i < 10; ++i) {
    for (const PlayerId id : {left, right}) simulation().act(id, wake);
    step(1);
  }
  wake.velocity[headYaw] = 0;
  for (const PlayerId id : {left, right}) simulation().act(id, wake);
  step(12);
  AgentCommand lean;
  lean.velocity[lAnklePitch] = lean.velocity[rAnklePitch] = -1.5;
  simulation().act(left, lean);
  step(25);
  lean.velocity[lAnklePitch] = lean.velocity[rAnklePitch] = 0;
  simulation().act(left, lean);
  step(22);
  if (GetParam().charges) {
    ASSERT_FALSE(fouls().empty());
    EXPECT_EQ(fouls()[0].kind, Foul::Kind::charging);
    EXPECT_EQ(fouls()[0].side, TeamSide::left);
    EXPECT_EQ(fouls()[0].unum, 2);
    step(20);
    EXPECT_LT((torso(left) - Vec3(-3, -10.5, 0.4)).norm(), 0.02);
  } else {
    EXPECT_TRUE(fouls().empty());
    EXPECT_NEAR(torso(left).x(), GetParam().x, 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(AtGaps, Charge, testing::Values(Fall{0.46, true, 0}, Fall{0.55, false, 0.346}));

TEST_F(League, monitorsGetFoulsAndTheRulesThatHold) {
  config.rules.time.half = 60;
  config.rules.restarts.distance = 1.5;
  for (int unum = 1; unum <= 4; ++unum) join("Red", unum);
  MonitorScene scene;
  const std::string first = scene.full(simulation());
  EXPECT_NE(first.find("(RuleHalfTime 60)"), std::string::npos);
  EXPECT_NE(first.find("(FreeKickDistance 1.5)"), std::string::npos);
  EXPECT_NE(first.find("(PassModeDuration 4)"), std::string::npos);
  playOn(Vec3(5, 5, 0.042));
  for (int unum = 1; unum <= 3; ++unum) put(TeamSide::left, unum, -14.5, unum - 2, 0);
  step(2);
  EXPECT_EQ(scene.difference(simulation()).find("foul"), std::string::npos);
  put(TeamSide::left, 4, -13.4, 2, 0);
  step(2);
  EXPECT_NE(scene.difference(simulation()).find(")(foul 1 2 1 4)"), std::string::npos);
  EXPECT_EQ(scene.difference(simulation()).find("foul"), std::string::npos) << "sent once";
  MonitorScene late;
  EXPECT_EQ(late.full(simulation()).find("(foul"), std::string::npos) << "not those from before";
}

TEST_F(League, monitorsLearnHowLongAGoalAfterPassModeDoesNotCount) {
  const PlayerId passer = join("Red", 7);
  step(60);
  playOn(Vec3(0, 0, 0.042));
  put(TeamSide::left, 7, -0.4, 0, 0);
  step(60);
  AgentCommand command;
  command.pass = true;
  simulation().act(passer, command);
  step(1);
  EXPECT_EQ(simulation().game().mode, PlayMode::passLeft);
  MonitorScene scene;
  EXPECT_NE(scene.full(simulation()).find("(play_mode 19)"), std::string::npos);
  step(201);
  EXPECT_EQ(simulation().game().mode, PlayMode::playOn);
  EXPECT_NE(scene.difference(simulation()).find("(pass_mode_score_wait_left 9.9"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::simulation
