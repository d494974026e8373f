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

void countWhatThePageCounts(const std::string& name) {
  SCOPED_TRACE(name);
  std::ifstream file("tests/data/touches/" + name + ".json");
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
  for (const auto& [team, side] : {std::pair("left", TeamSide::left), std::pair("right", TeamSide::right)}) {
    const json& expected = game["expected"][team];
    EXPECT_EQ(touches.touches(side), expected["touches"]) << team;
    EXPECT_EQ(touches.shots(side), expected["shots"]) << team;
    EXPECT_EQ(touches.passesMade(side), expected["made"]) << team;
    EXPECT_EQ(touches.passesCompleted(side), expected["passes"]) << team;
  }
}

TEST(BallTouches, countWhatThePageCounts) {
  countWhatThePageCounts("passes");
  countWhatThePageCounts("shots");
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
  moment.ball = {11, 0};
  pass({4.4, 0});
  EXPECT_EQ(touches.touches(TeamSide::left), 2);
  EXPECT_EQ(touches.shots(TeamSide::left), 1);
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

/// A player of the left team at the ball, which rests 3 m before the middle of the right goal.
class Shooter : public testing::Test {
protected:
  Shooter() { stand({12, 0}, {TeamSide::left, 2}); }
  void stand(const Vec2& ball, const BallMoment::Player& player) {
    moment.ball = ball;
    moment.players = {{player.side, player.number, ball - Vec2(0.2, 0)}};
    play(1, Vec2::Zero());
  }
  void play(double seconds, const Vec2& velocity) {
    const int steps = static_cast<int>(std::lround(10 * seconds));
    for (int i = 0; i < steps; ++i) {
      touches.observe(moment);
      moment.time += 0.1;
      moment.ball += 0.1 * velocity;
    }
  }
  void enter(const std::string& mode) {
    moment.mode = mode;
    play(0.5, Vec2::Zero());
  }
  /// Shots of left and right.
  std::pair<int, int> shots() const {
    return {touches.shots(TeamSide::left), touches.shots(TeamSide::right)};
  }
  BallMoment moment{.mode = "PlayOn"};
  BallTouches touches{halfLength, halfGoal};
};
using Shots = std::pair<int, int>;

TEST_F(Shooter, aFastBallToTheGoalIsAShotWhetherItGoesInOrNot) {
  play(0.6, {4, 0});
  EXPECT_EQ(shots(), Shots(1, 0));
  enter("Goal_Left");
  EXPECT_EQ(shots(), Shots(1, 0)) << "the goal is the same shot";
}

TEST_F(Shooter, aGoalIsAShotHoweverSlowTheBallWas) {
  play(3, {1, 0});
  EXPECT_EQ(shots(), Shots(0, 0));
  enter("Goal_Left");
  EXPECT_EQ(shots(), Shots(1, 0));
  enter("KickOff_Right");
  stand({0, 0}, {TeamSide::right, 5});
  play(1, {0, 3});
  EXPECT_EQ(touches.passesMade(TeamSide::left), 0) << "nor was it a pass to the kick-off";
}

TEST_F(Shooter, aTouchInTheMomentBeforeTheGoalIsTheShot) {
  stand({14.9, 0}, {TeamSide::left, 2});
  play(0.1, {1.2, 0});
  enter("Goal_Left");
  EXPECT_EQ(touches.touches(TeamSide::left), 1);
  EXPECT_EQ(shots(), Shots(1, 0));
}

TEST_F(Shooter, aGoalOfABallThatNobodyIsKnownToHaveTouchedIsAShotOfTheTeam) {
  moment.players.clear();
  play(0.6, {4, 0});
  enter("Goal_Left");
  EXPECT_EQ(shots(), Shots(1, 0));
}

TEST_F(Shooter, aPassTowardsTheGoalThatStopsShortIsNone) {
  stand({6, 0}, {TeamSide::left, 2});
  play(1, {4, 0});
  EXPECT_EQ(shots(), Shots(0, 0));
  stand({8, 0}, {TeamSide::left, 3});
  play(1, {4, 0});
  EXPECT_EQ(shots(), Shots(1, 0));
}

TEST_F(Shooter, howFarFromAndBesideTheGoal) {
  stand({2.9, 0}, {TeamSide::left, 2});
  play(1, {8, 0});
  EXPECT_EQ(shots(), Shots(0, 0)) << "from 12.1 m";
  stand({12, 1.6}, {TeamSide::left, 3});
  play(0.7, {4, 0});
  EXPECT_EQ(shots(), Shots(0, 0)) << "0.55 m beside the goal";
  stand({12, 1.5}, {TeamSide::left, 4});
  play(0.7, {4, 0});
  EXPECT_EQ(shots(), Shots(1, 0)) << "0.45 m beside the goal";
}

TEST_F(Shooter, anOwnGoalIsNone) {
  stand({12, 0}, {TeamSide::right, 7});
  play(0.7, {4, 0});
  enter("Goal_Left");
  EXPECT_EQ(touches.touches(TeamSide::right), 1);
  EXPECT_EQ(shots(), Shots(0, 0));
}

TEST_F(Shooter, aShotThatIsDeflectedIntoTheGoalCountsOnceForWhoShot) {
  moment.players.push_back({TeamSide::right, 1, {14, 0.2}});
  play(0.5, {4, 0});
  play(0.5, {2, 2});
  enter("Goal_Left");
  EXPECT_EQ(touches.touches(TeamSide::right), 1);
  EXPECT_EQ(shots(), Shots(1, 0));
}

TEST_F(Shooter, whoFollowsTheBallDribbles) {
  play(0.7, {2, 0});
  EXPECT_EQ(shots(), Shots(1, 0));
  stand({13.4, 0}, {TeamSide::left, 2});
  play(0.3, {3, 0});
  EXPECT_EQ(shots(), Shots(1, 0)) << "the second touch alone";
  EXPECT_EQ(touches.touches(TeamSide::left), 2);
}

TEST_F(Shooter, aKickAtWhoseEndAnOpponentIsNearerIsOneTouch) {
  moment.players.push_back({TeamSide::right, 1, {12.3, 0}});
  play(0.1, {1.4, 0.4});
  play(0.4, {6.7, 1.6});
  enter("Goal_Left");
  EXPECT_EQ(touches.touches(TeamSide::left), 1);
  EXPECT_EQ(touches.touches(TeamSide::right), 0);
  EXPECT_EQ(shots(), Shots(1, 0));
}

TEST_F(Shooter, anOpponentWhoSendsTheBallBackHasATouch) {
  moment.players.push_back({TeamSide::right, 1, {12.3, 0}});
  play(0.1, {1.4, 0.4});
  play(0.4, {-6.7, 1.6});
  EXPECT_EQ(touches.touches(TeamSide::right), 1);
}

}  // namespace
}  // namespace plumbline::watch
