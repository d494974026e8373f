#include "web/GameSummary.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "simspark/SceneState.h"
#include "support/Thrown.h"
#include "web/Frame.h"
#include "web/MatchFile.h"

namespace plumbline::web {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class GameSummaryTest : public ::testing::Test {
protected:
  GameSummaryTest() {
    folder = fs::temp_directory_path() / ("summary" + std::to_string(::getpid()) +
                                          ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder);
    file = folder / "match.plm";
  }
  ~GameSummaryTest() override { fs::remove_all(folder); }

  static std::string game(int left, const std::string& mode) {
    return json{{"kind", "game"},
                {"half", 1},
                {"mode", mode},
                {"left", {{"name", "L"}, {"score", left}}},
                {"right", {{"name", "R"}, {"score", 0}}}}
        .dump();
  }
  static std::string frame(double time, double x, bool second) {
    simspark::SceneState scene;
    scene.time = time;
    scene.ball = Vec3(x, -1, 0.04);
    simspark::SceneRobot robot;
    robot.side = TeamSide::left;
    robot.unum = 3;
    robot.T_world_torso.translation() = Vec3(x - 1, 2, 0.38);
    scene.robots.push_back(robot);
    robot.side = TeamSide::right;
    if (second) scene.robots.push_back(robot);
    return frameMessage(scene);
  }

  fs::path folder;
  std::string file;
};

TEST_F(GameSummaryTest, placesTenTimesASecondAndEachStateOnce) {
  {
    MatchWriter writer(file);
    writer.add(0, Channel::geometry, R"({"kind":"geometry","field":{"length":30}})");
    writer.add(0, Channel::game, game(0, "PlayOn"));
    for (int i = 0; i < 100; ++i) {  // 25 a second, over two chunks
      writer.add(0.04 * i, Channel::frame, frame(10 + 0.04 * i, 0.01 * i, i >= 50));
      writer.add(0.04 * i, Channel::game, game(i < 60 ? 0 : 1, "PlayOn"));
    }
  }
  const json tracks = json::parse(gameTracks(file));
  EXPECT_EQ(tracks["recording"], "match.plm");
  EXPECT_EQ(tracks["field"]["length"], 30);
  ASSERT_EQ(tracks["states"].size(), 2u);
  EXPECT_EQ(tracks["states"][1]["left"], 1);
  EXPECT_EQ(tracks["states"][1]["t"], 2.4);
  const std::size_t count = tracks["times"].size();
  EXPECT_GE(count, 33u);
  EXPECT_LE(count, 41u);
  EXPECT_EQ(tracks["clock"][0], 10);
  ASSERT_EQ(tracks["ball"].size(), 3 * count);
  EXPECT_EQ(tracks["ball"][0], 0);
  EXPECT_EQ(tracks["ball"][1], -100);
  ASSERT_EQ(tracks["robots"].size(), 2u);
  EXPECT_EQ(tracks["robots"][0]["side"], "left");
  EXPECT_EQ(tracks["robots"][0]["track"][1], 200);
  EXPECT_EQ(tracks["robots"][0]["track"][2], 1);
  // The second one came later.
  EXPECT_TRUE(tracks["robots"][1]["track"][0].is_null());
  EXPECT_EQ(tracks["robots"][1]["track"].back(), 1);
}

TEST_F(GameSummaryTest, aRecordingWithoutAGameIsRefused) {
  {
    MatchWriter writer(file);
    writer.add(0, Channel::game, game(0, "PlayOn"));
    writer.add(0, Channel::frame, std::string("\1\2 not a frame"));
  }
  EXPECT_EQ(thrownBy([&] { gameTracks(file); }), file + ": no game is in it");
  EXPECT_NE(thrownBy([&] { gameTracks(folder / "none.plm"); }), "nothing thrown");
}

TEST(SummaryPageTest, thePageHoldsWhatNoTeamsNameCanEnd) {
  EXPECT_EQ(summaryPage("<a>/*GAME*/</a>", R"({"name":"</script>"})", "http://x/"),
            "<a>{\"replay\":\"http://x/\",\"decisions\":null,\"game\":{\"name\":\"\\u003c/script>\"}}</a>");
  EXPECT_EQ(thrownBy([] { summaryPage("nothing", "{}", ""); }),
            "build/report/summary.html is broken: run `make web` again");
}

}  // namespace
}  // namespace plumbline::web
