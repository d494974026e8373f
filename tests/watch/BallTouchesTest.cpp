#include "watch/BallTouches.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

namespace plumbline::watch {
namespace {

using nlohmann::json;
using simspark::TeamSide;

constexpr double halfLength = 15, halfGoal = 1.05;

/// A place on a way [[t, x, y], ...], with straight motion between its points.
Vec2 placeAt(const json& way, double time) {
  std::size_t i = 1;
  while (i + 1 < way.size() && way[i][0].get<double>() < time) ++i;
  const double from = way[i - 1][0], to = way[i][0], part = (time - from) / (to - from);
  const auto at = [&](std::size_t axis) {
    return std::lerp(way[i - 1][axis].get<double>(), way[i][axis].get<double>(), part);
  };
  return {at(1), at(2)};
}

TEST(BallTouches, countWhatThePageCounts) {
  std::ifstream file("tests/data/touches/passes.json");
  const json game = json::parse(file);
  BallTouches touches(halfLength, halfGoal);
  for (int i = 0; i <= 10 * game["seconds"].get<int>(); ++i) {
    BallMoment moment{.time = i / 10.0, .ball = placeAt(game["ball"], i / 10.0)};
    for (const json& state : game["states"])
      if (state["t"].get<double>() <= moment.time) moment.mode = state["mode"];
    for (const json& player : game["players"])
      moment.players.push_back({player["side"] == "left" ? TeamSide::left : TeamSide::right, player["unum"],
                                placeAt(player["way"], moment.time)});
    touches.observe(moment);
  }
  for (const auto& [name, side] : {std::pair("left", TeamSide::left), std::pair("right", TeamSide::right)}) {
    const json& expected = game["expected"][name];
    EXPECT_EQ(touches.touches(side), expected["touches"]) << name;
    EXPECT_EQ(touches.passesMade(side), expected["made"]) << name;
    EXPECT_EQ(touches.passesCompleted(side), expected["passes"]) << name;
  }
}

/// Two mates on a line; the ball rolls from the first to the second, who stops it or sends it on.
class TwoMates : public testing::Test {
protected:
  void play(double seconds, const Vec2& velocity, double step = 0.1) {
    const int steps = static_cast<int>(std::lround(seconds / step));
    for (int i = 0; i < steps; ++i) {
      touches.observe(moment);
      moment.time += step;
      moment.ball += step * velocity;
    }
  }
  void pass(const Vec2& way, double step = 0.1) {
    moment.players = {{TeamSide::left, 2, moment.ball - Vec2(0.2, 0)},
                      {TeamSide::left, 3, moment.ball + way + Vec2(0, 0.2)}};
    play(1, Vec2::Zero(), step);
    play(2, way / 2, step);
    play(1, Vec2(0, -2), step);
  }
  BallMoment moment{.mode = "PlayOn", .ball = {-5, 0}};
  BallTouches touches{halfLength, halfGoal};
};

TEST_F(TwoMates, aPass) {
  pass({4, 0});
  EXPECT_EQ(touches.touches(TeamSide::left), 2);
  EXPECT_EQ(touches.passesMade(TeamSide::left), 1);
  EXPECT_EQ(touches.passesCompleted(TeamSide::left), 1);
}

TEST_F(TwoMates, scenesThatComeMoreOftenCountTheSame) {
  pass({4, 0}, 0.02);
  EXPECT_EQ(touches.touches(TeamSide::left), 2);
  EXPECT_EQ(touches.passesCompleted(TeamSide::left), 1);
}

TEST_F(TwoMates, aShortWayIsNoPass) {
  pass({1.8, 0});
  EXPECT_EQ(touches.passesMade(TeamSide::left), 1);
  moment.ball = {-5, 0};
  pass({1.2, 0});
  EXPECT_EQ(touches.passesMade(TeamSide::left), 1);
}

TEST_F(TwoMates, aShotIsNoPass) {
  moment.ball = {8, 0};
  pass({4, 0});
  EXPECT_EQ(touches.touches(TeamSide::left), 2);
  EXPECT_EQ(touches.passesMade(TeamSide::left), 0);
}

TEST_F(TwoMates, whileTheGameRestsNobodyTouches) {
  for (const char* mode : {"BeforeKickOff", "Goal_Left", "GameOver"}) {
    moment.mode = mode;
    pass({4, 0});
  }
  EXPECT_EQ(touches.touches(TeamSide::left), 0);
}

TEST_F(TwoMates, aBallThatIsPutElsewhereWasNotTouched) {
  moment.players = {{TeamSide::left, 2, moment.ball}};
  play(1, Vec2::Zero());
  play(0.1, Vec2(80, 0));
  play(1, Vec2::Zero());
  EXPECT_EQ(touches.touches(TeamSide::left), 0);
}

}  // namespace
}  // namespace plumbline::watch
