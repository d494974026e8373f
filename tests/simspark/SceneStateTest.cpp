#include "simspark/SceneState.h"

#include <gtest/gtest.h>

#include "support/Samples.h"

namespace plumbline::simspark {
namespace {

TEST(SceneState, twoRobotsOfTheLeaguesServer) {
  const auto messages = test::samples("monitor_two_agents");
  SceneState state;
  EXPECT_EQ(state.update(messages[1]), "a difference before a whole scene");
  ASSERT_EQ(state.update(messages[0]), "");
  EXPECT_EQ(state.teamLeft, "AA");
  EXPECT_EQ(state.teamRight, "BB");
  EXPECT_EQ(state.playMode, "PlayOn");
  EXPECT_EQ(state.half, 1);
  EXPECT_DOUBLE_EQ(state.time, 0.02);
  EXPECT_EQ(state.ball, Vec3(0, 0, 0.0417605));
  ASSERT_EQ(state.robots.size(), 2u);
  const SceneRobot* left = state.robot(TeamSide::left, 1);
  ASSERT_TRUE(left);
  EXPECT_EQ(left->type, 0);
  EXPECT_EQ(left->T_world_torso.translation(), Vec3(-0.975706, 0.00327678, 0.383871));
  EXPECT_NEAR(left->heading(), -0.0075, 1e-6);
  EXPECT_NEAR(left->T_world_torso.linear().determinant(), 1, 1e-4);
  EXPECT_GT(left->T_world_torso.linear()(2, 2), 0.999);
  const SceneRobot* right = state.robot(TeamSide::right, 2);
  ASSERT_TRUE(right);
  EXPECT_EQ(right->type, 4);
  EXPECT_FALSE(state.robot(TeamSide::left, 2));

  for (std::size_t i = 1; i < messages.size(); ++i) ASSERT_EQ(state.update(messages[i]), "") << i;
  EXPECT_NEAR(state.time, 0.22, 1e-9);
  EXPECT_EQ(state.robots.size(), 2u);
  EXPECT_EQ(state.field, FieldSize());
}

TEST(SceneState, takesTheFieldFromWhatTheServerTells) {
  SceneState state;
  ASSERT_EQ(state.update("((FieldLength 9)(FieldWidth 6)(GoalWidth 0)(PenaltyDepth 1.2)(time 1))"), "");
  EXPECT_EQ(state.field.length, 9);
  EXPECT_EQ(state.field.width, 6);
  EXPECT_EQ(state.field.goalWidth, FieldSize().goalWidth) << "no goal is 0 m wide";
  EXPECT_EQ(state.field.penaltyDepth, 1.2);
}

TEST(SceneState, tellsTheFoulsOfTheLastMessage) {
  SceneState scene;
  EXPECT_EQ(scene.update("((foul 3 6 2 5)(foul 4 1 1 11)(time 7))"), "");
  ASSERT_EQ(scene.fouls.size(), 2U);
  EXPECT_EQ(scene.fouls[0].index, 3);
  EXPECT_EQ(scene.fouls[0].kind, FoulKind::charging);
  EXPECT_EQ(scene.fouls[0].side, TeamSide::right);
  EXPECT_EQ(scene.fouls[0].unum, 5);
  EXPECT_EQ(scene.fouls[1].kind, FoulKind::touching);
  EXPECT_EQ(scene.fouls[1].side, TeamSide::left);
  EXPECT_EQ(scene.update("((foul 5 8 1 1)(foul 5 -1 1 1)(foul 5 6 3 1)(foul 5 6 1)(foul x 6 1 1)(foul))"),
            "");
  EXPECT_TRUE(scene.fouls.empty()) << "no such kind, no such side, too few numbers, no number";
}

TEST(SceneState, aMovedTransformIsTakenOver) {
  SceneState state;
  ASSERT_EQ(state.update("((play_modes A B)(play_mode 1)(time 1))(RSG 0 1)((nd Light)(nd TRF (SLT 1 0 0 0 0 "
                         "1 0 0 0 0 1 0 1 2 3 1)"
                         "(nd StaticMesh (load models/soccerball.obj))))"),
            "");
  EXPECT_EQ(state.ball, Vec3(1, 2, 3));
  EXPECT_EQ(state.playMode, "B");
  ASSERT_EQ(state.update("((time 2)(score_left 3)(play_mode 0))(RDS 0 1)((nd)(nd (SLT 1 0 0 0 0 1 0 0 0 0 1 "
                         "0 4 5 6 1)(nd)))"),
            "");
  EXPECT_EQ(state.ball, Vec3(4, 5, 6));
  EXPECT_EQ(state.scoreLeft, 3);
  EXPECT_EQ(state.playMode, "A");
}

TEST(SceneState, badMessagesAreNamed) {
  SceneState state;
  EXPECT_EQ(state.update("((time 1)"), "a parenthesis is not closed at byte 9");
  EXPECT_EQ(state.update(""), "no list of game state");
  EXPECT_EQ(state.update("((time 1))(RSG 0 1)"), "no scene");
  EXPECT_EQ(state.update("((time 1))(XYZ)(nd)"), "neither a scene nor a difference");
  EXPECT_EQ(state.update("((time 1))(RSG 0 1)((nd TRF (SLT 1 2)))"), "a transform without 16 numbers");
  ASSERT_EQ(state.update("((time 1))(RSG 0 1)((nd TRF))"), "");
  EXPECT_EQ(state.update("((time 1))(RDS 0 1)((nd)(nd))"), "a difference to another scene");
}

}  // namespace
}  // namespace plumbline::simspark
