#include "simspark/FieldMessage.h"

#include <gtest/gtest.h>

#include <numbers>

#include "simspark/FieldScene.h"
#include "simspark/Framing.h"
#include "support/Samples.h"

namespace plumbline::simspark {
namespace {

FieldState smallGame() {
  FieldState state;
  state.time = 83.42;
  state.half = 2;
  state.scoreLeft = 1;
  state.scoreRight = 3;
  state.playMode = "PlayOn";
  state.teamLeft = "Red";
  state.teamRight = "Blue";
  state.ball = Vec3(-1.234, 5, 0.042);
  state.robots = {{TeamSide::left, 1, Vec2(-14.5, 0), 0, false},
                  {TeamSide::right, 11, Vec2(3.006, -2), std::numbers::pi, true},
                  {TeamSide::none, 0, Vec2(0, -1), -std::numbers::pi / 2, false}};
  return state;
}

TEST(FieldMessage, toTheCharacter) {
  EXPECT_EQ(writeFieldMessage(smallGame()),
            "(field 1)(t 83.42)(s 2 1 3)(m PlayOn)(nl Red)(nr Blue)(b -123 500 4)(l 1 -1450 0 0)"
            "(r 11 301 -200 180 f)(o 0 0 -100 -90)");
}

TEST(FieldMessage, readBack) {
  FieldState read;
  ASSERT_EQ(readFieldMessage(writeFieldMessage(smallGame()), read), "");
  EXPECT_NEAR(read.time, 83.42, 1e-9);
  EXPECT_EQ(read.half, 2);
  EXPECT_EQ(read.scoreLeft, 1);
  EXPECT_EQ(read.scoreRight, 3);
  EXPECT_EQ(read.playMode, "PlayOn");
  EXPECT_EQ(read.teamLeft, "Red");
  EXPECT_EQ(read.teamRight, "Blue");
  EXPECT_NEAR((read.ball - Vec3(-1.23, 5, 0.04)).norm(), 0, 1e-9);
  ASSERT_EQ(read.robots.size(), 3u);
  EXPECT_EQ(read.robots[1].side, TeamSide::right);
  EXPECT_EQ(read.robots[1].unum, 11);
  EXPECT_NEAR((read.robots[1].position - Vec2(3.01, -2)).norm(), 0, 1e-9);
  EXPECT_NEAR(read.robots[1].heading, std::numbers::pi, 1e-9);
  EXPECT_TRUE(read.robots[1].fallen);
  EXPECT_FALSE(read.robots[2].fallen);
  EXPECT_EQ(read.robots[2].side, TeamSide::none);
}

TEST(FieldMessage, tellsAFieldThatIsNotTheLeagues) {
  FieldState state = smallGame();
  state.field.length = 9;
  state.field.width = 6;
  state.field.centreCircleRadius = 0.75;
  const std::string message = writeFieldMessage(state);
  EXPECT_NE(message.find("(nr Blue)(f 900 600 210 60 180 600 75)(b "), std::string::npos) << message;
  FieldState read;
  ASSERT_EQ(readFieldMessage(message, read), "");
  EXPECT_EQ(read.field.length, 9);
  EXPECT_EQ(read.field.centreCircleRadius, 0.75);
  EXPECT_EQ(readFieldMessage("(field 1)(f 900 0 210 60 180 600 75)", read), "cannot use (f ...)");
  EXPECT_EQ(read.field.width, 6) << "untouched";
}

/// Five messages a second of the longest kind that a game of 22 has stay below 4 kB.
TEST(FieldMessage, longestMessageOfAGame) {
  FieldState state;
  state.time = 9999.99;
  state.half = 2;
  state.scoreLeft = state.scoreRight = 10;
  state.playMode = "direct_free_kick_right";
  state.teamLeft = state.teamRight = std::string(500, 'x');
  state.ball = Vec3(-25, -20, 1.5);
  for (int i = 0; i < 22; ++i)
    state.robots.push_back({i < 11 ? TeamSide::left : TeamSide::right, 11, Vec2(-20.5, -14.5), -2.5, true});
  const std::size_t length = frameHeaderSize + writeFieldMessage(state).size();
  EXPECT_LE(length, 724u);
  EXPECT_LE(static_cast<double>(length) / fieldInterval, 4000);
}

TEST(FieldMessage, whatLiesFarOutIsClamped) {
  FieldState state;
  state.ball = Vec3(1e300, -1e300, std::nan(""));
  state.time = 1e300;
  EXPECT_EQ(writeFieldMessage(state), "(field 1)(t 99999.00)(s 0 0 0)(b 100000 -100000 0)");
}

TEST(FieldMessage, errorsAndNothingChanged) {
  FieldState state = smallGame();
  const auto problem = [&](const std::string& text) { return readFieldMessage(text, state); };
  EXPECT_EQ(problem("(field 1)(t x)"), "cannot use (t ...)");
  EXPECT_EQ(problem("(field 1)(b 1 2)"), "cannot use (b ...)");
  EXPECT_EQ(problem("(field 1)(l 1 2 3 1e9)"), "cannot use (l ...)");
  EXPECT_EQ(problem("(field 1) word"), "cannot use (word ...)");
  EXPECT_EQ(problem("(field 2)"), "field protocol 2, this program knows version 1");
  EXPECT_EQ(problem("(time 0)"), "no field message");
  EXPECT_EQ(problem("(field 1)(t 1"), "a parenthesis is not closed at byte 13");
  std::string crowd = "(field 1)";
  for (int i = 0; i < 65; ++i) crowd += "(l 1 0 0 0)";
  EXPECT_EQ(problem(crowd), "cannot use (l ...)");
  EXPECT_EQ(writeFieldMessage(state), writeFieldMessage(smallGame()));
  EXPECT_EQ(problem("(field 1)(later 1 2)"), "") << "lists of later versions are skipped";
}

TEST(FieldMessage, isSent) {
  EXPECT_TRUE(isFieldMessage("(field 1)(t 0)"));
  EXPECT_FALSE(isFieldMessage(test::samples("monitor_first3")[1]));
}

/// The quick reader tells the same as the thorough one, message by message.
TEST(FieldScene, asTheSceneState) {
  for (const char* name : {"monitor_two_agents", "monitor_first3"}) {
    SceneState whole;
    FieldScene quick;
    int compared = 0;
    for (const std::string& message : test::samples(name)) {
      EXPECT_EQ(quick.update(message), whole.update(message));
      EXPECT_EQ(quick.complete(), whole.complete());
      if (!whole.complete()) continue;
      EXPECT_EQ(writeFieldMessage(quick.state()), writeFieldMessage(fieldState(whole)));
      ++compared;
    }
    EXPECT_GT(compared, 2) << name;
  }
}

TEST(FieldScene, errors) {
  FieldScene scene;
  EXPECT_EQ(scene.update("((time 1)"), "no list of game state");
  EXPECT_EQ(scene.update("((time 1))(RDS 0 1)((nd))"), "a difference before a whole scene");
  const auto messages = test::samples("monitor_two_agents");
  EXPECT_EQ(scene.update(messages[0]), "");
  EXPECT_EQ(scene.update("((time 1))(RDS 0 1)((nd))"), "a difference to another scene");
  EXPECT_EQ(scene.update(messages[1]), "") << "goes on";
  EXPECT_EQ(scene.state().robots.size(), 2u);
}

TEST(FieldState, fromTheLeaguesMonitorPort) {
  SceneState scene;
  for (const std::string& message : test::samples("monitor_two_agents")) ASSERT_EQ(scene.update(message), "");
  const FieldState state = fieldState(scene);
  ASSERT_EQ(state.robots.size(), 2u);
  EXPECT_EQ(state.robots[0].side, TeamSide::left);
  EXPECT_EQ(state.robots[0].unum, 1);
  EXPECT_NEAR((state.robots[0].position - Vec2(-0.976, 0.003)).norm(), 0, 0.01);
  EXPECT_NEAR(state.robots[0].heading, 0, 0.02);
  EXPECT_EQ(state.robots[1].side, TeamSide::right);
  EXPECT_FALSE(state.robots[1].fallen);
  EXPECT_EQ(state.playMode, "PlayOn");
}

}  // namespace
}  // namespace plumbline::simspark
