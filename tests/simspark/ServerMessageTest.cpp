#include "simspark/ServerMessage.h"

#include <gtest/gtest.h>

#include <random>

#include "math/Angle.h"
#include "simspark/ServerMessageParser.h"
#include "simspark/ServerMessageWriter.h"
#include "support/Samples.h"

namespace plumbline::simspark {
namespace {

class Recorded : public testing::TestWithParam<const char*> {};

TEST_P(Recorded, everyMessageIsReadAndWrittenToTheSameBytes) {
  const auto messages = test::samples(GetParam());
  ASSERT_GE(messages.size(), 199u);
  for (std::size_t i = 0; i < messages.size(); ++i) {
    ServerMessage message;
    const auto error = parseServerMessage(messages[i], message);
    ASSERT_FALSE(error) << i << ": " << error->what << " at " << error->position;
    std::string written;
    appendServerMessage(written, message);
    ASSERT_EQ(written, messages[i]) << i;
  }
}
INSTANTIATE_TEST_SUITE_P(Samples, Recorded,
                         testing::Values("agent_type0", "agent_type1", "agent_type2", "agent_type3",
                                         "agent_type4", "agent_realtime_type0", "agent_game_22_players"));

ServerMessage parsed(std::string_view text) {
  ServerMessage message;
  const auto error = parseServerMessage(text, message);
  EXPECT_FALSE(error) << error->what << " at " << error->position << " of " << text;
  return message;
}

TEST(ServerMessage, convertsAxesDegreesAndSigns) {
  const auto m = parsed(
      "(time (now 8.5))(GS (unum 3) (team right) (sl 1) (sr 2) (t 0.48) (pm PlayOn))(GYR (n torso) (rt -57.3 "
      "2 3))"
      "(ACC (n torso) (a 1 2 9.81))(HJ (n hj2) (ax -45))(HJ (n rlj4) (ax -90))(HJ (n laj4) (ax -30))"
      "(FRP (n rf) (c 0.01 -0.02 -0.03) (f 1 2 3))(FRP (n lf1) (c 0 0.5 0) (f 0 0 6))");
  EXPECT_DOUBLE_EQ(m.time, 8.5);
  EXPECT_EQ(m.gameState.unum, 3);
  EXPECT_EQ(m.gameState.side, "right");
  EXPECT_EQ(m.gameState.scoreLeft, 1);
  EXPECT_EQ(m.gameState.scoreRight, 2);
  EXPECT_DOUBLE_EQ(m.gameState.time, 0.48);
  EXPECT_EQ(m.gameState.playMode, "PlayOn");
  EXPECT_LT((m.gyro - Vec3(fromDegrees(2), fromDegrees(57.3), fromDegrees(3))).norm(), 1e-12)
      << "the server tells degrees; pitching forward is positive about y";
  EXPECT_EQ(m.acc, Vec3(2, -1, 9.81));
  EXPECT_DOUBLE_EQ(*m.angle[headPitch], fromDegrees(45));
  EXPECT_DOUBLE_EQ(*m.angle[rKneePitch], fromDegrees(90)) << "bent is positive";
  EXPECT_DOUBLE_EQ(*m.angle[lElbowRoll], fromDegrees(-30));
  EXPECT_FALSE(m.angle[rToePitch]);
  EXPECT_EQ(m.rightFoot->point, Vec3(-0.02, -0.01, -0.03));
  EXPECT_EQ(m.rightFoot->force, Vec3(2, -1, 3));
  EXPECT_EQ(m.leftToe->point, Vec3(0.5, 0, 0));
  EXPECT_FALSE(m.leftFoot);
  EXPECT_FALSE(m.see);
}

TEST(ServerMessage, seenPointsInTheHeadFrame) {
  const auto m = parsed(
      "(See (F1L (pol 10 90 0)) (B (pol 2 0 -30)) (P (team B) (id 7) (head (pol 1 0 90)) (lfoot (pol 3 1 2)))"
      " (P (team L) (id 8)) (L (pol 1 2 3) (pol 4 5 6)))");
  ASSERT_EQ(m.see->objects.size(), 2u);
  EXPECT_EQ(m.see->objects[0].name, "F1L");
  EXPECT_LT((m.see->objects[0].position.cartesian() - Vec3(0, 10, 0)).norm(), 1e-12);
  EXPECT_LT((m.see->objects[1].position.cartesian() - Vec3(std::sqrt(3), 0, -1)).norm(), 1e-12);
  ASSERT_EQ(m.see->players.size(), 2u);
  EXPECT_EQ(m.see->players[0].team, "B");
  EXPECT_EQ(m.see->players[0].unum, 7);
  ASSERT_EQ(m.see->players[0].parts.size(), 2u);
  EXPECT_EQ(m.see->players[0].parts[1].name, "lfoot");
  EXPECT_DOUBLE_EQ(m.see->players[0].parts[1].position.distance, 3);
  EXPECT_EQ(m.see->players[1].unum, 8);
  ASSERT_EQ(m.see->lines.size(), 1u);
  EXPECT_DOUBLE_EQ(m.see->lines[0].b.elevation, fromDegrees(6));
}

TEST(ServerMessage, aPointThatTheLeaguesServerCouldNotClipIsLeftOut) {
  const ServerMessage message = parsed(
      "(time (now 1746.74))(See (L (pol nan nan nan) (pol 19.04 -60.09 -7.29)) (L (pol 1 2 3) (pol 4 -nan 6))"
      " (L (pol 1 2 3) (pol 4 5 6)) (F1L (pol nan 1 2)) (B (pol 7 8 9))"
      " (P (team L) (id 8) (head (pol 1 nan 1)) (rfoot (pol 1 1 1))))");
  ASSERT_EQ(message.see->lines.size(), 1u);
  EXPECT_EQ(message.see->lines[0].b.distance, 4);
  ASSERT_EQ(message.see->objects.size(), 1u);
  EXPECT_EQ(message.see->objects[0].name, "B");
  ASSERT_EQ(message.see->players.at(0).parts.size(), 1u);
  EXPECT_EQ(message.see->players[0].parts[0].name, "rfoot");
}

TEST(ServerMessage, heardWordsMayLookLikeAnything) {
  const auto m =
      parsed("(hear UT 1.50 self hi)(hear time 2.00 -90.00 See)(hear 3.00 45 12)(hear B 0 180 self)");
  ASSERT_EQ(m.heard.size(), 4u);
  EXPECT_TRUE(m.heard[0].self);
  EXPECT_EQ(m.heard[0].team, "UT");
  EXPECT_EQ(m.heard[1].team, "time");
  EXPECT_EQ(m.heard[1].text, "See");
  EXPECT_DOUBLE_EQ(m.heard[1].direction, fromDegrees(-90));
  EXPECT_EQ(m.heard[2].team, "");
  EXPECT_EQ(m.heard[2].text, "12");
  EXPECT_EQ(m.heard[3].text, "self");
  EXPECT_FALSE(m.heard[3].self);
}

TEST(ServerMessage, unknownNodesAreSkipped) {
  const auto m = parsed(
      "(TCH n bumper val 0)(IMG (s 2 (See 1)) (d aGVsbG8=))(time (zone (now 1)) (now 2.5))(UJ (n x)(ax1 "
      "1)(ax2 2))"
      "(GS (weather rain) (t 1) (pm PlayOn))(HJ (n nose1) (ax 5))(HJ (n hj1) (ax 9) (torque 5))"
      "(See (mypos 1 2 3) (B (pol 1 0 0) (colour red)) (T2 x) (P (team A) (id 1) (knee (pol 1 1 1)) (hat)) "
      "(D ((1) 2)))");
  EXPECT_DOUBLE_EQ(m.time, 2.5);
  EXPECT_DOUBLE_EQ(m.gameState.time, 1);
  EXPECT_DOUBLE_EQ(*m.angle[headYaw], fromDegrees(9));
  ASSERT_EQ(m.see->objects.size(), 1u);
  EXPECT_EQ(m.see->objects[0].name, "B");
  ASSERT_EQ(m.see->players.size(), 1u);
  ASSERT_EQ(m.see->players[0].parts.size(), 1u);
}

// Figure A.6.42 of the thesis, without its line breaks, cut behind the ground truth.
constexpr const char* groundTruthText =
    "(time (now 125.55))(GS (sl 0) (sr 0) (t 0.00) (pm BeforeKickOff))(hear RoboCanes 0.00 89.84 "
    "1Fnfj2d9zIaaaaaaaa)"
    "(GYR (n torso) (rt -0.10 -1.95 0.24))(ACC (n torso) (a 0.28 -0.01 0.08))"
    "(GT (mypos (pose -0.15 -2.20 0.00) (up 0.00 0.00 1.00) (z 0.40) (forward 1.00 0.00 -0.00)) (B (0.00 "
    "0.00 0.04))"
    " (P (team RoboCanes) (id 1) (pose -14.69 -0.00 0.01)) (P (team RoboCanes) (id 2) (pose -0.74 -0.05 "
    "-0.00)))"
    "(HJ (n hj1) (ax 87.19))(HJ (n hj2) (ax -46.41))";

TEST(ServerMessage, groundTruth) {
  const auto m = parsed(groundTruthText);
  ASSERT_TRUE(m.groundTruth);
  EXPECT_EQ(m.groundTruth->T_world_torso.translation(), Vec3(-0.15, -2.2, 0.4));
  EXPECT_TRUE(m.groundTruth->T_world_torso.linear().isIdentity(1e-12));
  EXPECT_EQ(m.groundTruth->ball, Vec3(0, 0, 0.04));
  ASSERT_EQ(m.groundTruth->players.size(), 2u);
  EXPECT_EQ(m.groundTruth->players[1].unum, 2);
  EXPECT_DOUBLE_EQ(m.groundTruth->players[0].heading, 0.01);
  std::string written;
  appendServerMessage(written, m);
  EXPECT_EQ(written, groundTruthText);
}

TEST(ServerMessage, groundTruthOfATiltedTorso) {
  ServerMessage m;
  m.gameState.playMode = "PlayOn";
  m.groundTruth.emplace();
  m.groundTruth->T_world_torso = translation(1, 2, 0.3) * rotationZ(2) * rotationX(-0.4) * rotationY(1.1);
  std::string written;
  appendServerMessage(written, m, 6);
  const auto again = parsed(written);
  EXPECT_TRUE(again.groundTruth->T_world_torso.isApprox(m.groundTruth->T_world_torso, 1e-5));
}

struct BadCase {
  const char* text;
  std::size_t position;
  const char* what;
};

TEST(ServerMessage, errorsNameThePlace) {
  for (const BadCase& bad : {
           BadCase{"(time (now x1))", 11, "'x1' is no number"},
           BadCase{"(GS (unum 1.5))", 10, "'1.5' is no whole number"},
           BadCase{"(time (now 1)", 13, "a parenthesis is not closed"},
           BadCase{"(time (now 1)))", 14, "a closing parenthesis without an opening one"},
           BadCase{"(GYR (n torso) (rt 1 2))", 16, "'rt' has not 3 words behind it"},
           BadCase{"(GYR (n torso) (rt 1 2 3 4))", 16, "'rt' has not 3 words behind it"},
           BadCase{"(time (now (1)))", 7, "'now' has not 1 word behind it"},
           BadCase{"(time 1)", 6, "'1' is no list, as fields of 'time' are"},
           BadCase{"(time (now 1)) word", 15, "a word outside of all parentheses"},
           BadCase{"(hear 1 self x)(hear 1 self)", 16, "'hear' has not 3 words behind it"},
           BadCase{"(See (B (pol 1 2)))", 9, "'pol' has not 3 words behind it"},
           BadCase{"(GT (B))", 5, "'B' has not one list of three numbers behind it"},
           BadCase{"(GT (B ()))", 5, "'B' has not one list of three numbers behind it"},
           BadCase{"(GT (B (1 2 3 4)))", 5, "'B' has not one list of three numbers behind it"},
           BadCase{"(GT (B (1 2 x)))", 12, "'x' is no number"},
           BadCase{"(ACC (n torso) (a 1 nan 2))", 20, "'nan' is no number"},
           BadCase{"(GT (mypos (up 0 0 1)(forward 0 0 1)))", 1, "the axes of mypos span no frame"},
       }) {
    ServerMessage message;
    const auto error = parseServerMessage(bad.text, message);
    ASSERT_TRUE(error) << bad.text;
    EXPECT_EQ(error->what, bad.what) << bad.text;
    EXPECT_EQ(error->position, bad.position) << bad.text;
  }
}

TEST(ServerMessage, holdsWhatCameBeforeAnError) {
  ServerMessage message;
  EXPECT_TRUE(parseServerMessage("(time (now 3))(HJ (n hj1) (ax 5))(HJ (n hj2) (ax x))(GS (t 4))", message));
  EXPECT_EQ(message.time, 3);
  EXPECT_TRUE(message.angle[headYaw]);
  EXPECT_FALSE(message.angle[headPitch]) << "half of a node is none";
  EXPECT_EQ(message.gameState.time, 0);
  EXPECT_TRUE(parseServerMessage("(time (now 2))(GS (t 4)", message));
  EXPECT_EQ(message.time, 2);
  EXPECT_EQ(message.gameState.time, 0);
}

TEST(ServerMessage, aSensorWithoutItsReadingIsLeftOut) {
  const ServerMessage message = parsed("(HJ (n hj1) (ax 5))(HJ (n hj2))(FRP (n lf) (c 1 1 1))");
  EXPECT_FALSE(message.angle[headPitch]);
  EXPECT_FALSE(message.leftFoot);
}

TEST(ServerMessage, aSensorWithoutNameIsNotTheOneBefore) {
  const ServerMessage message =
      parsed("(HJ (n hj1) (ax 5))(HJ (ax 7))(FRP (n lf) (c 1 1 1) (f 1 1 1))(FRP (f 2 2 2))");
  EXPECT_DOUBLE_EQ(*message.angle[headYaw], fromDegrees(5));
  EXPECT_EQ(message.leftFoot->force, Vec3(1, -1, 1));
}

TEST(ServerMessage, oneParserReadsMessageAfterMessage) {
  ServerMessageParser parser;
  ServerMessage message;
  EXPECT_FALSE(parser.parse("(time (now 1))(See (B (pol 1 2 3)))", message));
  EXPECT_TRUE(parser.parse("(time", message));
  EXPECT_FALSE(message.see);
  EXPECT_FALSE(parser.parse("(time (now 2))", message));
  EXPECT_EQ(message.time, 2);
  EXPECT_FALSE(message.see);
}

TEST(ServerMessage, emptyAndHugeAndDeep) {
  ServerMessage message;
  EXPECT_FALSE(parseServerMessage("", message));
  EXPECT_FALSE(parseServerMessage(" \n\t", message));
  EXPECT_TRUE(parseServerMessage(std::string(5 << 20, '('), message));
  std::string many;
  for (int i = 0; i < 1 << 15; ++i) many += "(x)";
  EXPECT_EQ(parseServerMessage(many + "(x)", message)->what, "too many elements");
  const auto error = parseServerMessage(std::string(100000, '('), message);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->what, "nested too deeply");
}

// Damaged messages must neither crash nor hang; the sanitizers watch.
TEST(ServerMessage, survivesDamage) {
  const auto messages = test::samples("agent_type4");
  std::mt19937 random(3);
  const std::string_view letters = "() \0-.0123456789eE+nai\xff\x80(PL";
  int errors = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string text = messages[random() % messages.size()];
    for (unsigned n = 1 + random() % 6; n > 0; --n) {
      const std::size_t at = random() % text.size();
      switch (random() % 3) {
        case 0:
          text[at] = letters[random() % letters.size()];
          break;
        case 1:
          text.erase(at, 1 + random() % 30);
          break;
        default:
          text.insert(at, text.substr(random() % text.size(), random() % 40));
      }
      if (text.empty()) text = "(";
    }
    ServerMessage message;
    errors += parseServerMessage(text, message).has_value();
    std::string written;
    appendServerMessage(written, message);
  }
  EXPECT_GT(errors, 1000);
  EXPECT_LT(errors, 3000);
}

}  // namespace
}  // namespace plumbline::simspark
