#include "web/ReplayFeed.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "support/FarOff.h"
#include "support/Thrown.h"

namespace plumbline::web {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class ReplayFeedTest : public ::testing::Test {
protected:
  ReplayFeedTest() {
    folder = fs::temp_directory_path() / ("replay" + std::to_string(::getpid()) +
                                          ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder);
    file = folder / "match.plm";
  }
  ~ReplayFeedTest() override { fs::remove_all(folder); }

  static std::string game(int left, int right) {
    return json{{"kind", "game"},
                {"left", {{"name", "L"}, {"score", left}}},
                {"right", {{"name", "R"}, {"score", right}}}}
        .dump();
  }
  json latest(Channel channel) const {
    const Broadcast::Message message = broadcast.latest(channel).message;
    return message ? json::parse(*message) : json::object();
  }

  fs::path folder;
  std::string file;
  Broadcast broadcast;
};

TEST_F(ReplayFeedTest, aRecordedGameIsNotLive) {
  {
    MatchWriter writer(file);
    writer.add(0, Channel::game, game(1, 2));
    writer.add(0, Channel::frame, std::string(100, 'f'));
  }
  const ReplayFeed feed(file, broadcast);
  EXPECT_EQ(latest(Channel::game)["live"], false);
  EXPECT_EQ(latest(Channel::game)["source"], file);
  EXPECT_EQ(latest(Channel::game)["right"]["score"], 2);
}

TEST_F(ReplayFeedTest, refusesAGameNestedWithoutEnd) {
  {
    MatchWriter writer(file);
    writer.add(0, Channel::game, std::string(300000, '['));
    writer.add(0, Channel::frame, std::string(100, 'f'));
  }
  EXPECT_EQ(thrownBy([&] { const ReplayFeed feed(file, broadcast); }),
            file + ": the game's state at 0.00 s is nested deeper than 16 levels");
}

TEST_F(ReplayFeedTest, saysWhereInTheFileTheGameIsBroken) {
  {
    MatchWriter writer(file);
    writer.add(0, Channel::game, game(0, 0));
    for (int i = 0; i <= 250; ++i) {
      if (i == 150) writer.add(6, Channel::game, std::string(300000, '['));
      writer.add(0.04 * i, Channel::frame, std::string(100, 'f'));
    }
  }
  ReplayFeed feed(file, broadcast);
  feed.command(Seek{7});
  EXPECT_TRUE(comesTrue([&] { return !latest(Channel::replay).value("problem", "").empty(); }));
  EXPECT_EQ(latest(Channel::replay)["problem"],
            file + ": the game's state at 6.00 s is nested deeper than 16 levels");
}

TEST_F(ReplayFeedTest, marksTheGoals) {
  {
    MatchWriter writer(file);
    writer.add(0, Channel::game, game(0, 0));
    for (int i = 0; i <= 250; ++i) {
      if (i == 75) writer.add(3, Channel::game, game(1, 0));
      if (i == 200) writer.add(8, Channel::game, game(1, 1));
      if (i == 225) writer.add(9, Channel::game, game(0, 0));  // the trainer's reset is no goal
      writer.add(0.04 * i, Channel::frame, std::string(100, 'f'));
    }
  }
  ReplayFeed feed(file, broadcast);
  const auto goals = [&] { return latest(Channel::replay).value("goals", json::array()); };
  EXPECT_TRUE(comesTrue([&] { return goals().size() >= 2; }));
  EXPECT_EQ(goals(), json::parse(R"([{"time": 3.0, "side": "left"}, {"time": 8.0, "side": "right"}])"));
}

}  // namespace
}  // namespace plumbline::web
