#include "web/PageCommand.h"

#include <gtest/gtest.h>

namespace plumbline::web {
namespace {

/// What the trainer port is sent for a page's message.
std::string sent(const std::string& json) {
  PageCommand command = Seek{-1};
  if (const std::string problem = parsePageCommand(json, command); !problem.empty()) {
    EXPECT_TRUE(std::holds_alternative<Seek>(command)) << "untouched";
    return problem;
  }
  const auto* trainer = std::get_if<simspark::TrainerCommand>(&command);
  return trainer ? simspark::writeTrainerCommand(*trainer) : "other";
}

TEST(PageCommand, buttons) {
  EXPECT_EQ(sent(R"({"do":"kickOff","side":"left"})"), "(kickOff Left)");
  EXPECT_EQ(sent(R"({"do":"kickOff","side":"right"})"), "(kickOff Right)");
  EXPECT_EQ(sent(R"({"do":"playMode","mode":"PlayOn"})"), "(playMode PlayOn)");
  EXPECT_EQ(sent(R"({"do":"dropBall"})"), "(dropBall)");
  EXPECT_EQ(sent(R"({"do":"pause"})"), "(pause)");
  EXPECT_EQ(sent(R"({"do":"resume"})"), "(resume)");
  EXPECT_EQ(sent(R"({"do":"step","cycles":3})"), "(step 3)");
  EXPECT_EQ(sent(R"({"do":"speed","speed":2.5})"), "(speed 2.500000)");
  EXPECT_EQ(sent(R"({"do":"moveBall","x":1,"y":-2,"z":0.042})"),
            "(ball (pos 1.000000 -2.000000 0.042000)(vel 0.000000 0.000000 0.000000))");
  EXPECT_EQ(sent(R"({"do":"kickBall","x":3,"y":0,"z":1})"), "(ball (vel 3.000000 0.000000 1.000000))");
  EXPECT_EQ(sent(R"({"do":"moveRobot","side":"right","unum":4,"x":1,"y":2,"z":0.4})"),
            "(agent (unum 4)(team Right)(pos 1.000000 2.000000 0.400000))");
}

TEST(PageCommand, ofARecording) {
  PageCommand command;
  ASSERT_EQ(parsePageCommand(R"({"do":"seek","time":12.5})", command), "");
  EXPECT_EQ(std::get<Seek>(command).time, 12.5);
  ASSERT_EQ(parsePageCommand(R"({"do":"stop"})", command), "");
  EXPECT_FALSE(std::get<PlayRecording>(command).playing);
  ASSERT_EQ(parsePageCommand(R"({"do":"rate","rate":0.5})", command), "");
  EXPECT_EQ(std::get<RecordingRate>(command).rate, 0.5);
}

TEST(PageCommand, aNewGame) {
  PageCommand command;
  ASSERT_EQ(parsePageCommand(R"({"do":"reset"})", command), "");
  EXPECT_TRUE(std::holds_alternative<ResetGame>(command));
  std::string all;
  for (const auto& part : resetGame({})) all += simspark::writeTrainerCommand(part);
  EXPECT_EQ(all,
            "(playMode BeforeKickOff)(score (left 0)(right 0))(time 0.000000)"
            "(ball (pos 0.000000 0.000000 0.042000)(vel 0.000000 0.000000 0.000000))");
}

TEST(PageCommand, nothingElseGetsThrough) {
  EXPECT_EQ(sent("(killsim)"), "not a JSON object");
  EXPECT_EQ(sent("[]"), "not a JSON object");
  EXPECT_EQ(sent(R"({"do":"killsim"})"), "no such command");
  EXPECT_EQ(sent(R"({})"), "no such command");
  EXPECT_EQ(sent(R"({"do":3})"), "a value of the wrong type");
  EXPECT_EQ(sent(R"({"do":"kickOff","side":"up"})"), "'side' is neither left nor right");
  EXPECT_EQ(sent(R"({"do":"playMode","mode":"PlayOn)(killsim"})"), "'mode' is no play mode");
  EXPECT_EQ(sent(R"({"do":"moveBall","x":1e9,"y":0,"z":0})"), "'x' is out of range");
  EXPECT_EQ(sent(R"({"do":"moveBall","x":"1","y":0,"z":0})"), "no number 'x'");
  EXPECT_EQ(sent(R"({"do":"speed","speed":0.001})"), "'speed' is out of range");
  EXPECT_EQ(sent(R"({"do":"moveRobot","side":"left","unum":12,"x":0,"y":0,"z":0})"),
            "'unum' is out of range");
}

}  // namespace
}  // namespace plumbline::web
