#include "watch/GameWatch.h"

#include <gtest/gtest.h>

#include <future>

#include "framework/StopSignal.h"
#include "modules/simspark/FakeServer.h"

namespace plumbline::watch {
namespace {

/// A whole scene in which so many players of the left team stand.
std::string sceneText(const std::string& mode, double time, int players) {
  const std::string place = "(SLT 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0.4 1)";
  std::string text = "((play_modes BeforeKickOff PlayOn GameOver)(time " + std::to_string(time) +
                     ")(half 1)(team_left A)(team_right B)(score_left 2)(score_right 1)(play_mode " + mode +
                     "))(RSG 0 1)((nd TRF " + place + ")";
  for (int i = 1; i <= players; ++i)
    text += "(nd TRF " + place + "(nd StaticMesh (load models/naobody0.obj)(resetMaterials matNum" +
            std::to_string(i) + " matLeft)))";
  return text + ")";
}
const std::string beforeKickOff = "0", playOn = "1", gameOver = "2";

struct GameWatchTest : testing::Test {
  GameWatchTest() {
    options.port = server.port();
    options.players = 2;
    options.patience = 0.3;
    options.settle = 0;
  }
  ~GameWatchTest() override { stop.request(0, "the test is over"); }
  void begin() {
    result = std::async(std::launch::async, [this] {
      return watchGame(options, stop,
                       [this](const simspark::SceneState& scene) { seen.push_back(scene.playMode); });
    });
    server.accept();
  }

  test::FakeServer server;
  GameWatchOptions options;
  StopSignal stop;
  std::vector<std::string> seen;  ///< play modes of the progress
  std::future<GameResult> result;
};

TEST_F(GameWatchTest, kicksOffWithThoseWhoCameInTimeAndEndsWithTheGame) {
  begin();
  server.send(sceneText(beforeKickOff, 0, 1));
  ASSERT_EQ(server.receive(), "(kickOff Left)") << "one of two, and nobody more is waited for";
  server.send(sceneText(playOn, 12, 1));
  server.send(sceneText(gameOver, 600, 1));
  const GameResult game = result.get();
  EXPECT_EQ(game.end, GameEnd::over) << game.problem;
  EXPECT_EQ(game.teamLeft + ":" + game.teamRight, "A:B");
  EXPECT_EQ(game.scoreLeft, 2);
  EXPECT_EQ(game.scoreRight, 1);
  EXPECT_EQ(game.gameSeconds, 600);
  ASSERT_FALSE(seen.empty());
  EXPECT_EQ(seen.front(), "BeforeKickOff");
}

TEST_F(GameWatchTest, kicksOffAtOnceWhenEverybodyIsThere) {
  options.patience = 600;
  begin();
  server.send(sceneText(beforeKickOff, 0, 2));
  EXPECT_EQ(server.receive(), "(kickOff Left)");
}

TEST_F(GameWatchTest, waitsForPlayersAsLongAsItsPatienceLasts) {
  begin();
  server.send(sceneText(beforeKickOff, 0, 0));
  const GameResult game = result.get();
  EXPECT_EQ(game.end, GameEnd::noPlayers) << game.problem;
  EXPECT_GE(game.wallSeconds, 0.3);
}

TEST_F(GameWatchTest, aServerThatGoesEndsTheGame) {
  begin();
  server.send(sceneText(playOn, 12, 2));
  server.drop();
  EXPECT_EQ(result.get().end, GameEnd::serverGone);
}

}  // namespace
}  // namespace plumbline::watch
