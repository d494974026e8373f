#include "simspark/AgentCommand.h"

#include <gtest/gtest.h>

namespace plumbline::simspark {
namespace {

TEST(AgentCommand, writesTheLeaguesWords) {
  AgentCommand command;
  command.scene = SceneRequest{.type = 4};
  EXPECT_EQ(writeAgentCommand(command), "(scene rsg/agent/nao/nao_hetero.rsg 4)");
  command = {};
  command.init = InitRequest{3, "Plumb"};
  command.syn = true;
  EXPECT_EQ(writeAgentCommand(command), "(init (unum 3)(teamname Plumb))(syn)");
  command = {};
  command.beam = Pose2(-1.5, 2, pi / 2);
  command.velocity[headYaw] = 0.5;
  command.velocity[lKneePitch] = 0.25;
  command.velocity[rShoulderPitch] = -1;
  command.say = "hi";
  command.pass = true;
  EXPECT_EQ(writeAgentCommand(command),
            "(beam -1.50000 2.00000 90.00000)(he1 0.50000)(rae1 1.00000)(lle4 -0.25000)(say hi)(pass)");
}

TEST(AgentCommand, readsWhatItWrites) {
  AgentCommand command, read;
  command.scene = SceneRequest{"rsg/agent/nao/nao.rsg", 0};
  command.init = InitRequest{11, "A"};
  command.beam = Pose2(-10, -3.25, -1);
  for (int i = 0; i < numHumanoidJoints; ++i) command.velocity[std::size_t(i)] = 0.125 * (i - 10);
  command.say = "~!@#";
  command.pass = command.syn = true;
  AgentCommandParser parser;
  EXPECT_EQ(parser.parse(writeAgentCommand(command), read), "");
  EXPECT_TRUE(parser.wellFormed());
  EXPECT_EQ(read.scene->file, command.scene->file);
  EXPECT_EQ(read.init->unum, 11);
  EXPECT_EQ(read.init->team, "A");
  EXPECT_EQ(read.beam->position, command.beam->position);
  EXPECT_NEAR(read.beam->heading, -1, 1e-6);
  EXPECT_EQ(read.velocity, command.velocity);
  EXPECT_EQ(read.say, "~!@#");
  EXPECT_TRUE(read.pass && read.syn);
}

TEST(AgentCommand, whatCannotBeUsedIsSkippedAndNamedOnce) {
  AgentCommand read;
  AgentCommandParser parser;
  EXPECT_EQ(parser.parse("(dance 1 2)(he1 x)(he2 1)(scene)(beam 1 2)(init (unum 1))(say a b)(syn)", read),
            "cannot use (dance ...)");
  EXPECT_TRUE(parser.wellFormed());
  EXPECT_FALSE(read.velocity[headYaw] || read.scene || read.beam || read.init || read.say);
  EXPECT_EQ(read.velocity[headPitch], -1);
  EXPECT_TRUE(read.syn);
}

TEST(AgentCommand, garbageIsNotWellFormed) {
  AgentCommand read;
  AgentCommandParser parser;
  EXPECT_EQ(parser.parse("(he1 1)(he2 1", read), "a parenthesis is not closed at byte 13");
  EXPECT_FALSE(parser.wellFormed());
  EXPECT_TRUE(read.velocity[headYaw]);
  EXPECT_FALSE(read.velocity[headPitch]);
  EXPECT_EQ(parser.parse("GET / HTTP/1.1", read), "cannot use (GET ...)");
  EXPECT_FALSE(parser.wellFormed());
  EXPECT_EQ(parser.parse("", read), "");
  EXPECT_TRUE(parser.wellFormed());
}

TEST(AgentCommand, sayable) {
  EXPECT_TRUE(isSayable("a"));
  EXPECT_TRUE(isSayable("12345678901234567890"));
  EXPECT_FALSE(isSayable("123456789012345678901"));
  for (const char* text : {"", "a b", "(", ")", "\x7f", "\xc3\xa4", "\n"})
    EXPECT_FALSE(isSayable(text)) << text;
}

TEST(AgentCommand, namesOfTeams) {
  EXPECT_TRUE(isTeamName("Plumbline_2"));
  EXPECT_TRUE(isTeamName(std::string(20, 'a')));
  EXPECT_FALSE(isTeamName(std::string(21, 'a')));
  for (const char* text : {"", "a b", "a(", ")", "\"", "a\"b", "\x7f", "\xc3\xa4", "\n"})
    EXPECT_FALSE(isTeamName(text)) << text;
}

}  // namespace
}  // namespace plumbline::simspark
