#include "simulation/monitor/MonitorScene.h"

#include <gtest/gtest.h>

#include "simspark/SceneState.h"
#include "support/Samples.h"

namespace plumbline::simulation {
namespace {

/// A text in which every list that begins so is replaced.
std::string replaceLists(const std::string& text, const std::string& beginning,
                         const std::string& replacement) {
  std::string out;
  for (std::size_t at = 0;;) {
    const std::size_t begin = text.find(beginning, at);
    out += text.substr(at, begin - at);
    if (begin == std::string::npos) return out;
    at = text.find(')', begin) + 1;
    out += replacement;
  }
}

/// A text without the numbers of its transforms.
std::string withoutTransforms(const std::string& text) { return replaceLists(text, "(SLT ", "(SLT)"); }

int count(const std::string& text, const std::string& word) {
  int n = 0;
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size()) ++n;
  return n;
}

PlayerId join(Simulation& simulation, int type, const std::string& team, int unum, const Vec3& place) {
  const PlayerId id = simulation.addPlayer(type);
  simspark::AgentCommand command;
  command.init = simspark::InitRequest{unum, team};
  EXPECT_EQ(simulation.act(id, command), "");
  const auto& player = *simulation.allPlayers().at(id);
  simulation.train(simspark::MoveAgentCommand{simspark::PlayerName{unum, player.side}, place, 0});
  return id;
}

/// The league's scene with two robots, up to the number of its lines.
class TwoRobots : public testing::Test {
protected:
  TwoRobots() {
    first = join(simulation, 0, "AA", 1, Vec3(-1, 0, 0.384));
    second = join(simulation, 4, "BB", 2, Vec3(2, -1, 0.384));
    simulation.train(simspark::PlayModeCommand{PlayMode::playOn});
    simulation.step();
  }
  Simulation simulation{SimulationConfig{}};
  PlayerId first = 0, second = 0;
  MonitorScene scene;
};

TEST_F(TwoRobots, wholeSceneToTheCharacterOfTheLeagues) {
  const std::string recorded = test::samples("monitor_two_agents")[0], ours = scene.full(simulation);
  EXPECT_EQ(withoutTransforms(ours), withoutTransforms(recorded));
  const std::size_t ball = recorded.find("(nd TRF (SLT", recorded.find("(SLT 1 0 0 0 0 1 0 0 0 0 1 0 0 -25"));
  EXPECT_EQ(ours.substr(0, ball), recorded.substr(0, ball)) << "what stands still, with its numbers";
}

TEST_F(TwoRobots, emptySceneToTheCharacter) {
  Simulation empty{SimulationConfig{}};
  const std::string recorded = test::samples("monitor_first3")[1];
  EXPECT_EQ(withoutTransforms(scene.full(empty)), withoutTransforms(recorded));
  const std::string difference = test::samples("monitor_first3")[5];
  EXPECT_EQ(scene.difference(empty), difference);
}

TEST_F(TwoRobots, differenceHasTheSameNodes) {
  scene.full(simulation);
  const std::string recorded = test::samples("monitor_two_agents")[1];
  const auto nodes = [](const std::string& text) {
    return replaceLists(replaceLists(text, " (SLT ", ""), "(time ", "");
  };
  EXPECT_EQ(nodes(scene.difference(simulation)), nodes(recorded));
}

TEST_F(TwoRobots, aTransformIsSentWhenItHasMovedFarEnough) {
  scene.full(simulation);
  EXPECT_EQ(count(scene.difference(simulation), "SLT"), 0);
  simulation.train(simspark::BallCommand{Vec3(0.0049, 0, 0.042), Vec3(0, 0, 0)});
  EXPECT_EQ(count(scene.difference(simulation), "SLT"), 0);
  simulation.train(simspark::BallCommand{Vec3(0.0151, 0, 0.042), Vec3(0, 0, 0)});
  EXPECT_EQ(count(scene.difference(simulation), "SLT"), 1);
  EXPECT_EQ(count(scene.difference(simulation), "SLT"), 0);
  simulation.train(
      simspark::MoveAgentCommand{simspark::PlayerName{1, TeamSide::left}, Vec3(-2, 1, 0.384), 0});
  EXPECT_EQ(count(scene.difference(simulation), "SLT"), 23) << "every body of one robot of type 0";
}

TEST_F(TwoRobots, aClientSeesWhatIs) {
  simspark::SceneState state;
  ASSERT_EQ(state.update(scene.full(simulation)), "");
  for (int i = 0; i < 20; ++i) {
    simulation.train(simspark::BallCommand{Vec3(0.1 * i, 1, 0.5), Vec3(0, 0, 0)});
    simulation.train(simspark::MoveAgentCommand{simspark::PlayerName{2, TeamSide::right},
                                                Vec3(2, -1 - 0.1 * i, 0.384), 0.1 * i});
    simulation.step();
    ASSERT_EQ(state.update(scene.difference(simulation)), "");
    EXPECT_LT((state.ball - simulation.world().ball().pose.translation()).norm(), 0.009);
    for (const auto& [id, player] : simulation.allPlayers()) {
      const simspark::SceneRobot* robot = state.robot(player->side, player->unum);
      ASSERT_TRUE(robot);
      EXPECT_EQ(robot->type, player->type());
      const Pose3 torso = simulation.world().torso(player->robot).pose;
      EXPECT_LT((robot->T_world_torso.matrix() - torso.matrix()).cwiseAbs().maxCoeff(), 0.0051);
    }
  }
  simulation.train(simspark::ScoreCommand{2, 1});
  simulation.train(simspark::PlayModeCommand{PlayMode::goalRight});
  ASSERT_EQ(state.update(scene.difference(simulation)), "");
  EXPECT_EQ(state.scoreLeft, 2);
  EXPECT_EQ(state.playMode, "Goal_Right");
  EXPECT_EQ(state.teamRight, "BB");
  EXPECT_EQ(count(scene.difference(simulation), "score"), 0) << "sent once";
}

TEST_F(TwoRobots, theSelectedRobotIsMarked) {
  scene.full(simulation);
  simulation.train(simspark::SelectCommand{simspark::PlayerName{1, TeamSide::left}});
  EXPECT_EQ(count(scene.difference(simulation), "(nd SMN (setVisible 1))"), 1);
  EXPECT_EQ(count(scene.difference(simulation), "setVisible"), 0);
  simulation.train(simspark::SelectCommand{{}, true});
  EXPECT_EQ(count(scene.difference(simulation), "(nd SMN (setVisible 0))"), 1);
}

/// Goals, walls, flags, rules and what monitors get follow the sizes of the field.
TEST(MonitorScene, aSmallFieldIsSentAsItIs) {
  SimulationConfig config;
  config.world.field.length = 9;
  config.world.field.width = 6;
  config.world.field.centreCircleRadius = 0.75;
  const Simulation small(config);
  MonitorScene scene;
  const std::string message = scene.full(small);
  EXPECT_TRUE(message.starts_with("((FieldLength 9)(FieldWidth 6)(FieldHeight 40)(GoalWidth 2.1)"))
      << message.substr(0, 99);
  EXPECT_NE(message.find("(PassModeDuration 4)(CentreCircleRadius 0.75)("), std::string::npos);
  simspark::SceneState state;
  ASSERT_EQ(state.update(message), "");
  EXPECT_EQ(state.field, config.world.field);
}

TEST(MonitorScene, materialsOfARobotWithoutATeam) {
  EXPECT_EQ(materialNames("num team type naowhite", 2, 0, TeamSide::none),
            "matNum matTeam matType2 naowhite");
  EXPECT_EQ(materialNames("num team naowhite", 4, 11, TeamSide::right), "matNum11 matRight naowhite");
}

}  // namespace
}  // namespace plumbline::simulation
