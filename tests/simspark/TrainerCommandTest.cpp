#include "simspark/TrainerCommand.h"

#include <gtest/gtest.h>

#include "math/Angle.h"

namespace plumbline::simspark {
namespace {

std::vector<TrainerCommand> commandsIn(std::string_view text, const std::string& problem = "") {
  std::vector<TrainerCommand> commands;
  EXPECT_EQ(TrainerCommandParser().parse(text, commands), problem) << text;
  return commands;
}

TEST(TrainerCommand, everyCommandIsReadAsItIsWritten) {
  const PlayerName player{7, TeamSide::right};
  const std::vector<std::pair<TrainerCommand, const char*>> all = {
      {MoveAgentCommand{player, Vec3(1, 2, 0.4), {}},
       "(agent (unum 7)(team Right)(pos 1.000000 2.000000 0.400000))"},
      {MoveAgentCommand{player, Vec3(1, 2, 0.4), pi},
       "(agent (unum 7)(team Right)(move 1.000000 2.000000 0.400000 90.000000))"},
      {MoveAgentCommand{}, "(agent )"},
      {BallCommand{Vec3(1, 0, 0.042), Vec3(3, 0, 3)},
       "(ball (pos 1.000000 0.000000 0.042000)(vel 3.000000 0.000000 3.000000))"},
      {BallCommand{{}, Vec3(1, 0, 0)}, "(ball (vel 1.000000 0.000000 0.000000))"},
      {PlayModeCommand{PlayMode::directFreeKickRight}, "(playMode direct_free_kick_right)"},
      {KickOffCommand{TeamSide::left}, "(kickOff Left)"},
      {KickOffCommand{TeamSide::none}, "(kickOff None)"},
      {DropBallCommand{}, "(dropBall)"},
      {TimeCommand{12.5}, "(time 12.500000)"},
      {ScoreCommand{1, 2}, "(score (left 1)(right 2))"},
      {SelectCommand{player}, "(select (unum 7)(team Right))"},
      {SelectCommand{{}, true}, "(select (unum -1))"},
      {KillCommand{player}, "(kill (unum 7)(team Right))"},
      {KillCommand{}, "(kill )"},
      {RepositionCommand{player}, "(repos (unum 7)(team Right))"},
      {FullStateCommand{}, "(reqfullstate)"},
      {AcknowledgeCommand{}, "(getAck)"},
      {KillSimulatorCommand{}, "(killsim)"},
      {ResetCommand{}, "(reset)"},
      {ResetCommand{7}, "(reset 7)"},
  };
  for (const auto& [command, text] : all) {
    EXPECT_EQ(writeTrainerCommand(command), text);
    const auto again = commandsIn(text);
    ASSERT_EQ(again.size(), 1u) << text;
    EXPECT_EQ(again[0].index(), command.index()) << text;
    EXPECT_EQ(writeTrainerCommand(again[0]), text);
  }
}

TEST(TrainerCommand, severalInOneMessage) {
  const auto commands = commandsIn("(kickOff Left)(agent (team Left)(unum 2)(move -1 0.5 0.4 -90))(time 3)");
  ASSERT_EQ(commands.size(), 3u);
  const auto& move = std::get<MoveAgentCommand>(commands[1]);
  EXPECT_EQ(move.player->unum, 2);
  EXPECT_EQ(*move.position, Vec3(-1, 0.5, 0.4));
  EXPECT_NEAR(*move.heading, 0, 1e-12) << "the league's -90 degrees look to the right goal";
}

TEST(TrainerCommand, badOnesAreSkippedAndNamed) {
  for (const char* bad :
       {"(fly)", "(playMode Sleep)", "(kickOff Up)", "(time -1)", "(time)", "(score (left 1))",
        "(score (left -1)(right 0))", "(ball (pos 1 2))", "(agent (unum 1)(team Left)(move 1 2 3))",
        "(ball (vel 1 2 nan))", "(ball (vel 1e308 1e308 1e308))", "(ball (pos 1e4 0 0))", "(time 1e300)",
        "(agent (unum 1)(team Left)(pos 0 0 -1e9))", "(score (left 10000)(right 0))",
        "(agent (unum 1)(team Left)(move 2000 0 0 0))", "(agent (unum 1)(team Left)(move 1 2 0.4 1e9))"}) {
    const std::string name(bad + 1, std::string_view(bad).find_first_of(" )") - 1);
    EXPECT_EQ(commandsIn(std::string(bad) + "(dropBall)", "cannot use (" + name + " ...)").size(), 1u) << bad;
  }
  EXPECT_TRUE(commandsIn("(time 1", "a parenthesis is not closed at byte 7").empty());
}

TEST(TrainerCommand, aViewerIsSentToEveryMillisecondToEveryMinute) {
  for (const char* interval : {"0.001", "0.04", "60"}) {
    const auto commands = commandsIn("(viewer " + std::string(interval) + ")");
    ASSERT_EQ(commands.size(), 1U) << interval;
    EXPECT_EQ(std::get<ViewerCommand>(commands[0]).interval, std::stod(interval));
  }
  for (const char* interval : {"0", "0.0009", "60.1", "-1", "soon"})
    EXPECT_TRUE(commandsIn("(viewer " + std::string(interval) + ")", "cannot use (viewer ...)").empty())
        << interval;
}

}  // namespace
}  // namespace plumbline::simspark
